#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "ricochet/machine.h"
#include "ricochet/problem.h"
#include "ricochet/random.h"
#include "ricochet/scene.h"
#include "src/report/results.h"
#include "src/report/site/study.h"

namespace ricochet::studies {

/// How far can the surrogate and its gradient be trusted? Takes some minutes on two
/// processors.
Study surrogate_study();

}  // namespace ricochet::studies

/// The four questions of the study. Each has a function that computes a table with a row for every
/// observation, in parallel and with the same bits for any number of threads, and one that adds
/// what the page shows of it.
namespace ricochet::studies::surrogate {

/// Surrogate bias: how far the surrogate's optima are from those of the count, for every case and
/// smoothing parameter, from wide to narrow; `step` [rad/s] between the speeds, up to 18 rad/s.
/// Columns: case; fastest [rad/s], at which the count is quiet; smoothing; speed, the fastest at
/// which the surrogate is quiet, and speed_optimality_gap = fastest - speed [rad/s], both missing
/// if it never is; quiet, whether the count is quiet at that speed; count_optimality_gap, the count
/// at the surrogate's minimum minus the lowest.
Table bias(double step, const std::vector<double>& smoothings);

/// Adds the finding, the tables bias and quiet-speeds, and the chart speed-gap.
void add_bias(report::Results& results, const Table& bias, double step);

/// A larger change of the surrogate between neighbouring floating-point numbers needs an
/// explanation. One cause is known: a newly appearing impact has about 1e-8 of the speeds around
/// it, the square root of their rounding, and at smoothing parameter 1 its weight is its speed over
/// the limit, about 1e-6.
inline constexpr double largest_allowed = 1e-5;

/// The scene at a share in [0, 1] of a segment of a line through the constants of a machine.
using Segment = std::function<carrier_track::Scene(double share)>;

/// Returns a segment near a scene: it starts at 1..17 rad/s, with parameters changed by up to a
/// quarter; speed, friction, restitution and clearance change linearly, all at once.
Segment random_segment(const carrier_track::Scene& scene, Random& random);

/// Changes of the surrogate between neighbouring numbers on random segments through the constants
/// of the cases: at least 54 for each smoothing parameter, one per lively case, 8 per other. A
/// segment takes 65 to 120 simulations. Columns: smoothing; count_jumps, whether the count differs
/// between some of 17 points; steepest, the change where the surrogate changes most; strike, the
/// change where the number of strikes changes (impacts on another wall than the one before),
/// missing if it does not; exponent, p of the change over 2 distance ~ distance^p there, between
/// 1e-12 and 1e-10 of the segment, 0 for a jump, 1/2 for a square root, 1 for a slope, missing if
/// it hardly changes.
Table changes(const std::vector<double>& smoothings, std::size_t segments, std::uint64_t seed);

/// Adds the table continuity and the values that the page's section names.
void add_continuity(report::Results& results, const Table& changes);

/// The surrogate's gradient of every case, at so many points in each of the cells of the range of
/// speeds. Columns: smoothing; case; speed, the middle of the cell [rad/s]; flat, kink and
/// sensitive, by its GradientDoubt; right, wrong and neither: whether its sign is that of the
/// count's trend, and neither if the count has none or the gradient is flat.
Table gradients(const std::vector<double>& smoothings, int cells, int points);

/// Adds the table validity, the chart validity-trend and the values of default_smoothing.
void add_gradients(report::Results& results, const Table& gradients);

/// Relative errors of derivatives above this are outliers, whose cause is determined.
inline constexpr double outlier = 1e-6;

/// Exact derivatives of all problems of the families that have some, or whose surrogate has,
/// compared with extrapolated differences at random points along random directions in a box of
/// width 1; the points are divided evenly over the families. A row for the objective and for every
/// constraint: family; function, "objective" or "constraints"; problem; at, the first coordinate;
/// exact; difference; error, estimated, of the difference; reach; relative, the difference of the
/// two over the larger; cause: "none" if that is no outlier, else "flat" (by a negligible amount),
/// "reach" (the steps exceeded the gradient's reach; shorter ones agree), "rounding" (below 1e-3,
/// and no more than differences vary) or "unexplained".
Table derivatives(const std::vector<Family>& families, std::size_t points, std::uint64_t seed);

/// The same at one point of the unit box, at least 1e-3 from its faces, along a direction of length
/// 1.
Table derivatives_at(const std::string& family, const Problem& problem, const Vector& point,
                     const Vector& direction);

/// Adds the tables derivatives and unexplained, and the values that the page's section names.
void add_derivatives(report::Results& results, const Table& derivatives);

/// Uniform in [a, b).
inline double within(Random& random, double a, double b) {
  return a + (b - a) * uniform(random);
}

/// A quantile of the values of a group.
std::function<Value(const std::vector<Value>&)> quantile_of(double q);

/// A piece of a range and how much a function changes over it.
struct Piece {
  double lower, upper;
  double at_lower, at_upper;

  double change() const { return std::abs(at_upper - at_lower); }
};

/// Returns the piece with the largest change, of the even pieces of [0, 1] between the values of a
/// function at their ends; at least two values.
Piece steepest_piece(const std::vector<double>& values);

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

}  // namespace ricochet::studies::surrogate
