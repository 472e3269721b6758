#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/random.h"
#include "ricochet/scene.h"
#include "src/report/json.h"

/// Is the surrogate continuous where the count jumps?
namespace ricochet::studies::surrogate {

/// A larger change of the surrogate between neighbouring floating-point numbers needs an
/// explanation. One cause is known: a newly appearing impact has about 1e-8 of the speeds around
/// it, the square root of their rounding, and at smoothing parameter 1 its weight is its speed over
/// the limit, about 1e-6.
inline constexpr double largest_allowed = 1e-5;

struct ContinuityPlan {
  std::vector<double> smoothings;  ///< > 0
  std::size_t
      segments;  ///< in total, >= 54 per smoothing parameter: 1 per lively case, 8 per other
  std::uint64_t seed;
};

/// A path from one scene to a nearby one: speed, friction, restitution and clearance change
/// linearly, all at once.
struct Segment {
  carrier_track::Scene start;
  double faster;    ///< [rad/s]
  double rougher;   ///< of the coefficient of friction
  double livelier;  ///< of both restitutions
  double wider;     ///< [m], of the clearance

  /// The scene at the share t in [0, 1] of the path.
  carrier_track::Scene at(double t) const;
};

/// Returns a segment near a scene: at 1..17 rad/s, its parameters changed by up to a quarter.
Segment random_segment(const carrier_track::Scene& scene, Random& random);

/// The jumps on one segment.
struct Jumps {
  bool of_count;     ///< true if the count differs between some of 17 points
  double surrogate;  ///< the largest between neighbouring numbers, see largest_jump.h
  /// The surrogate's change between the neighbouring numbers where the number of strikes changes,
  /// i.e. of impacts on another wall than the previous one: where a wall is touched, or the window
  /// ends. Nothing if that number is the same at all points.
  std::optional<double> at_birth;
  /// At that place, p of the surrogate's change over 2 distance
  /// distance^p, between 1e-12 and 1e-10 of the segment; 0 for a jump, 1/2 for a square root, 1 for
  /// a slope. Nothing if it hardly changes.
  std::optional<double> exponent;
};

Jumps jumps_of(const Segment& segment, double smoothing);

/// One case.
struct ContinuityRow {
  std::string id;
  std::size_t segments = 0;
  std::size_t count_jumps = 0;  ///< segments on which the count jumps
  std::vector<std::vector<double>>
      jumps;  ///< by smoothing parameter: the largest of each segment, rising
  std::vector<std::vector<double>> births;  ///< by smoothing parameter: those at births, rising
  std::vector<double> exponents;            ///< of births, see Jumps, rising
};

struct ContinuityStudy {
  ContinuityPlan plan;
  std::vector<ContinuityRow> rows;  ///< one for each case, in the default interpretation
};

/// In parallel, with the same bits for any number of threads. Each segment uses one of the
/// smoothing parameters, in turn: about 65 to 120 simulations.
ContinuityStudy study_continuity(const ContinuityPlan& plan);

report::Json data_of(const ContinuityStudy& study);

}  // namespace ricochet::studies::surrogate
