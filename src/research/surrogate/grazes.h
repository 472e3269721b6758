#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/models/impact_model.h"
#include "src/report/json.h"

/// What the surrogate's slope does next to a graze: a speed at which a wall is touched at rest.
namespace ricochet::studies::surrogate {

/// Grazes are approached in shares of this range of speeds [rad/s].
inline constexpr double graze_range = 18;

struct Graze {
  double omega;              ///< [rad/s]
  int side;                  ///< +1: the wall is hit above that speed, -1: below
  carrier_track::Wall wall;  ///< that is touched
  double time;               ///< [s]
};

/// Grazes of a valid scene between two speeds [rad/s], each within a rounding or so, at most one
/// between neighbours of `steps` + 1 even speeds: where a strike's time jumps, and the strike on
/// the one side is next to nothing. A strike is an impact on another wall than the one before.
std::vector<Graze> find_grazes(const carrier_track::Scene& scene, double lower, double upper,
                               int steps);

/// The surrogate on both sides of a graze.
struct Approach {
  double distance;                 ///< share of the range
  double hit_slope, missed_slope;  ///< per rad/s
  double hit_reach, missed_reach;  ///< Trust::reach in the range
};

Approach approach(const carrier_track::Scene& scene, const Graze& graze, double width,
                  double distance);

struct GrazePlan {
  int steps;                      ///< of the search between 1 and 17 rad/s
  std::size_t each;               ///< at most so many grazes of a case, the slowest
  std::vector<double> widths;     ///< > 0, the default first
  std::vector<double> distances;  ///< shares of the range, falling, 1e-6 at most the last
};

struct GrazeRow {
  std::string id;
  Graze graze;
  std::vector<std::vector<Approach>> approaches;  ///< a width, a distance each
  /// A width each: p of |hit slope - missed slope| ~ distance^p, by least squares over the
  /// distances from 1e-11 to 1e-7; nothing where the two are the same.
  std::vector<std::optional<double>> exponents;

  /// Whether anything that counts follows the graze before the motion forgets it: the slope then
  /// grows without limit, with an exponent of -0.5. It is 1 where the slopes come together, and 0
  /// where one side keeps another slope than the other.
  bool followed() const { return exponents.front() && *exponents.front() < -0.25; }
};

struct GrazeStudy {
  GrazePlan plan;
  std::vector<GrazeRow> rows;  ///< of C1..C12 in the default reading
};

GrazeStudy study_grazes(const GrazePlan& plan);

/// Null where nothing that counts follows any graze.
report::Json data_of(const GrazeStudy& study);

}  // namespace ricochet::studies::surrogate
