#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/motion/impact_model.h"
#include "ricochet/machine.h"
#include "src/report/results.h"

/// The surrogate's slope next to a graze: a speed at which a wall is touched with velocity zero.
namespace ricochet::studies::surrogate {

/// Distances to grazes are shares of this range of speeds [rad/s].
inline constexpr double graze_range = 18;

struct Graze {
  double omega;              ///< [rad/s]
  int side;                  ///< +1: the wall is hit above that speed, -1: below
  carrier_track::Wall wall;  ///< that is touched
  double time;               ///< [s]
};

/// Finds grazes of a valid scene between two speeds [rad/s], each to about rounding, at most one
/// between neighbours of `steps` + 1 even speeds: where a strike's time jumps, and the strike on
/// one side has almost no speed. A strike is an impact on another wall than the previous one.
std::vector<Graze> find_grazes(const carrier_track::Scene& scene, double lower, double upper,
                               int steps);

/// The surrogate on both sides of a graze.
struct Approach {
  double distance;                 ///< share of the range
  double hit_slope, missed_slope;  ///< per rad/s
  double hit_reach, missed_reach;  ///< Trust::reach in the range
};

Approach approach(const carrier_track::Scene& scene, const Graze& graze, double smoothing,
                  double distance);

struct GrazePlan {
  int steps;                       ///< of the search between 1 and 17 rad/s
  std::size_t each;                ///< at most this number of grazes of a case, the slowest
  std::vector<double> smoothings;  ///< > 0
  std::vector<double> distances;   ///< shares of the range, falling, from 1e-6
};

struct GrazeRow {
  std::string id;
  Graze graze;
  std::vector<std::vector<Approach>> approaches;  ///< by smoothing parameter and distance
  /// For each smoothing parameter: p of |hit slope - missed slope| ~ distance^p, by least squares
  /// over the distances from 1e-11 to 1e-7; nothing if the two are equal.
  std::vector<std::optional<double>> exponents;

  /// Returns true if the slope grows without limit towards the graze, because a counted impact
  /// follows before the motion forgets it. The exponent is then -0.5; it is 1 if the slopes of both
  /// sides converge, and 0 if they stay apart.
  bool grows(std::size_t smoothing) const {
    return exponents[smoothing] && *exponents[smoothing] < -0.25;
  }
};

struct GrazeStudy {
  GrazePlan plan;
  std::vector<GrazeRow> rows;  ///< of C1..C12 in the default interpretation
};

GrazeStudy study_grazes(const GrazePlan& plan);

/// Adds the tables grazes (a row for each) and graze-growth (a row for each smoothing parameter),
/// and the values that the page's section names. Nothing if there are no grazes.
void add_to(report::Results& results, const GrazeStudy& study);

}  // namespace ricochet::studies::surrogate
