#pragma once

#include <cmath>
#include <limits>

#include "src/core/bracketed_root.h"

namespace ricochet::carrier_track::inline reference_integrators {

/// The point where f, not positive at `lower` and positive at `upper`, becomes positive: at most a
/// few roundings of `upper` behind a sign change. If there are several sign changes, it is any of
/// them. f(result) may be 0.
template <class Function>
double rise(Function f, double lower, double upper) {
  const double at_lower = f(lower);
  if (at_lower >= 0) return lower;
  const double width = 4 * std::numeric_limits<double>::epsilon() * upper;
  return bracketed_root(f, lower, upper, at_lower, f(upper),
                        [width](double a, double b) { return b - a <= width; })
      .second;
}

struct Slope {
  double value, slope;
};

/// The point where f, positive at `lower` or right behind it, and not at `upper`, has fallen to
/// zero, to a few roundings of `upper`; `lower` if f is nowhere positive. f(time) returns a Slope.
/// Newton's iteration in a bracket, from the root of a parabola through both ends.
///
/// NOTE: an integration with event location spends most of its time here; for these smooth, nearly
/// parabolic functions this needs half the time of toms748_solve.
template <class Function>
double fall(Function f, double lower, double upper) {
  const double width = 4 * std::numeric_limits<double>::epsilon() * upper;
  const double length = upper - lower;
  const auto [start, slope_at_start] = f(lower);
  const double bend = (f(upper).value - start - slope_at_start * length) / (length * length);
  const double root = std::sqrt(slope_at_start * slope_at_start - 4 * bend * start);
  double next = lower + (slope_at_start > 0 ? -0.5 * (slope_at_start + root) / bend
                                            : 2 * start / (root - slope_at_start));
  double time = upper;
  while (upper - lower > width) {
    if (!(next > lower && next < upper)) next = lower + 0.5 * (upper - lower);
    const bool converged = std::abs(next - time) <= width;
    time = next;
    if (converged) break;
    const auto [value, slope] = f(time);
    (value > 0 ? lower : upper) = time;
    next = time - value / slope;
  }
  return time;
}

}  // namespace ricochet::carrier_track::inline reference_integrators
