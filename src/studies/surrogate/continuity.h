#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/random.h"
#include "ricochet/scene.h"
#include "src/report/results.h"

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
  double surrogate;  ///< the largest between neighbouring numbers, see continuity.h
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

/// Adds the table and the chart continuity, and the values that the page's section names.
void add_to(report::Results& results, const ContinuityStudy& study);

struct Point {
  double x, y;
};

/// Slope of the line through finite points by least squares; nothing for fewer than three points,
/// or if all x are equal.
inline std::optional<double> slope_of(const std::vector<Point>& points) {
  if (points.size() < 3) return std::nullopt;
  double x = 0;
  double y = 0;
  for (const Point& point : points) {
    x += point.x / static_cast<double>(points.size());
    y += point.y / static_cast<double>(points.size());
  }
  double square = 0;
  double product = 0;
  for (const Point& point : points) {
    square += (point.x - x) * (point.x - x);
    product += (point.x - x) * (point.y - y);
  }
  if (square == 0) return std::nullopt;
  return product / square;
}

/// A piece of [0, 1] and how much a function changes over it.
struct Piece {
  double lower, upper;
  double at_lower, at_upper;

  double change() const { return std::abs(at_upper - at_lower); }
};

/// Returns the piece with the largest change, of the even pieces of [0, 1] between the values of a
/// function at their ends; at least two values.
inline Piece steepest_piece(const std::vector<double>& values) {
  const double pieces = static_cast<double>(values.size() - 1);
  Piece steepest{0, 0, values[0], values[0]};
  for (std::size_t k = 1; k < values.size(); ++k) {
    const double end = static_cast<double>(k);
    const Piece piece{(end - 1) / pieces, end / pieces, values[k - 1], values[k]};
    if (k == 1 || piece.change() > steepest.change()) steepest = piece;
  }
  return steepest;
}

/// Returns two neighbouring numbers of a piece, by bisection that always takes the half where f
/// changes more.
template <class Function>
Piece narrowed(Piece piece, const Function& f) {
  for (;;) {
    const double middle = piece.lower + (piece.upper - piece.lower) / 2;
    if (!(middle > piece.lower && middle < piece.upper)) return piece;
    const double now = f(middle);
    if (std::abs(now - piece.at_lower) > std::abs(piece.at_upper - now)) {
      piece.upper = middle;
      piece.at_upper = now;
    } else {
      piece.lower = middle;
      piece.at_lower = now;
    }
  }
}

/// Returns the change of f between two neighbouring numbers, found from the largest of its changes
/// over 16 pieces of [0, 1].
template <class Function>
double largest_jump(const Function& f) {
  constexpr int pieces = 16;
  std::vector<double> values;
  for (int k = 0; k <= pieces; ++k) values.push_back(f(static_cast<double>(k) / pieces));
  return narrowed(steepest_piece(values), f).change();
}

}  // namespace ricochet::studies::surrogate
