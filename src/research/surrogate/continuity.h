#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/scene/scene.h"
#include "src/core/random.h"
#include "src/report/json.h"

/// Is the surrogate continuous where the count jumps?
namespace ricochet::studies::surrogate {

/// A larger change of the surrogate between neighbouring numbers wants a reason. One is known: an
/// impact that is born strikes at some 1e-8 of the speeds around it, the root of what they are
/// rounded to, and at width 1 it weighs its speed over the limit, which is some 1e-6.
inline constexpr double largest_allowed = 1e-5;

struct ContinuityPlan {
  std::vector<double> widths;  ///< > 0
  std::size_t segments;        ///< in all, 54 a width or more: one a lively case, eight another
  std::uint64_t seed;
};

/// A way from one scene to another near it: speed, friction, restitution and clearance change
/// evenly, all at once.
struct Segment {
  carrier_track::Scene start;
  double faster;    ///< [rad/s]
  double rougher;   ///< of the coefficient of friction
  double livelier;  ///< of both restitutions
  double wider;     ///< [m], of the clearance

  /// The scene at the share t in [0, 1] of the way.
  carrier_track::Scene at(double t) const;
};

/// A segment near a scene: at 1..17 rad/s, its constants changed by up to a quarter.
Segment random_segment(const carrier_track::Scene& scene, Random& random);

/// What one segment shows.
struct Jumps {
  bool of_count;     ///< whether the count differs between some of 17 points
  double surrogate;  ///< the largest between neighbouring numbers, see largest_jump.h
  /// The surrogate's between the neighbouring numbers where the number of strikes changes, impacts
  /// on another wall than the one before: where a wall is touched, or the window ends. Nothing
  /// where that number is the same at all points.
  std::optional<double> at_birth;
  /// There: p of the surrogate's change over 2 distance ~ distance^p, between 1e-12 and 1e-10 of
  /// the segment; 0 for a jump, 1/2 for a root, 1 for a slope. Nothing where it hardly changes.
  std::optional<double> exponent;
};

Jumps jumps_of(const Segment& segment, double width);

/// One case.
struct ContinuityRow {
  std::string id;
  std::size_t segments = 0;
  std::size_t count_jumps = 0;              ///< segments on which the count does
  std::vector<std::vector<double>> jumps;   ///< a width: the largest of each segment, rising
  std::vector<std::vector<double>> births;  ///< a width: those at births, rising
  std::vector<double> exponents;            ///< of births, see Jumps, rising
};

struct ContinuityStudy {
  ContinuityPlan plan;
  std::vector<ContinuityRow> rows;  ///< a case each, in the default reading
};

/// In parallel, with the same bits for any number of threads. Each segment is looked at with one of
/// the widths, in turn: some 65 to 120 simulations.
ContinuityStudy study_continuity(const ContinuityPlan& plan);

report::Json data_of(const ContinuityStudy& study);

}  // namespace ricochet::studies::surrogate
