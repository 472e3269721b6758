#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

/// The first point at which a function of time falls below zero, isolated by bounds that exclude
/// missed roots. Slow and simple: the basis of the oracle.
namespace ricochet::carrier_track::inline oracle {

/// A function and two derivatives at one time.
struct Jet {
  long double value, slope, curvature;
};

/// Bounds that hold at all times of a search.
struct JetBounds {
  long double third;        ///< bound on the magnitude of the third derivative
  long double slope_noise;  ///< rounding error of the slope
};

/// The result of a search. In [lower, upper] the function crosses zero once downwards (falls), or
/// stays positive while the caller's event occurs (passes); or it is positive up to the horizon
/// (never).
struct Search {
  enum class End { falls, passes, never } end;
  long double lower, upper;
};

/// Searches (0, horizon] for the first fall of `jet` below zero. `jet(t)` is a Jet; it is zero or
/// positive at 0, and if it is zero its slope is not negative. `noise(t)` bounds its rounding
/// error: values within it count as zero, and zero is no fall. `passed(t)` ends the search early at
/// the end of a piece without roots. `guess` > 0 is the length of the first piece; any value will
/// do.
///
/// A piece of middle m and half width h has no roots if the Taylor expansion about m, with the
/// bound on the third derivative as remainder, proves it for the function, or proves that it is
/// monotone, convex or concave and its ends exclude a root. A piece for which nothing is proved is
/// halved.
template <class Function, class Noise, class Passed>
Search first_fall(const Function& jet, const JetBounds& bounds, const Noise& noise,
                  const Passed& passed, long double horizon, long double guess) {
  constexpr long double last_bit = std::numeric_limits<long double>::epsilon();
  long double lower = 0;
  Jet start = jet(lower);
  if (start.value < -noise(lower)) return {Search::End::falls, lower, lower};
  long double width = std::min(guess, horizon);
  while (lower < horizon) {
    const long double upper = std::min(lower + width, horizon);
    const long double h = (upper - lower) / 2;
    const Jet middle = jet(lower + h);
    const Jet stop = jet(upper);
    const long double rounding = noise(upper);
    const long double slope_reach = std::abs(middle.curvature) * h + bounds.third * h * h / 2;
    const long double reach = std::abs(middle.slope) * h + std::abs(middle.curvature) * h * h / 2 +
                              bounds.third * h * h * h / 6;
    const bool positive = middle.value > reach + rounding;
    const bool rises = middle.slope > slope_reach + bounds.slope_noise;
    const bool drops = middle.slope < -slope_reach - bounds.slope_noise;
    const bool convex = middle.curvature > bounds.third * h;
    const bool concave = middle.curvature < -bounds.third * h;
    const bool zero = std::abs(middle.value) + reach <= 2 * rounding;
    const bool smallest = h <= last_bit * upper;
    if ((drops || smallest) && stop.value < -rounding) {
      return {Search::End::falls, lower, upper};
    }
    const bool free = positive || rises || zero || smallest || drops ||
                      (convex && start.slope >= -bounds.slope_noise) ||
                      (concave && stop.value > rounding);
    if (!free) {
      width = h;
      continue;
    }
    if (passed(upper)) return {Search::End::passes, lower, upper};
    lower = upper;
    start = stop;
    width = 4 * std::max(h, last_bit * upper);
  }
  return {Search::End::never, horizon, horizon};
}

/// The root in [lower, upper] of a function with one sign change there, to the last bits; `lower`
/// if the sign does not change. `jet(t)` is a Jet. Newton's method within a bracket: a step that
/// leaves it, or that is more than half the previous one, is replaced by a bisection.
template <class Function>
long double root_between(const Function& jet, long double lower, long double upper) {
  constexpr long double last_bit = std::numeric_limits<long double>::epsilon();
  const long double low = jet(lower).value;
  if (low == 0) return lower;
  Jet now = jet(upper);
  if ((low > 0) == (now.value > 0) && now.value != 0) return lower;
  long double time = upper;
  long double step = upper - lower;
  while (now.value != 0 && upper - lower > last_bit * upper) {
    const long double before = step;
    step = std::abs(now.value / now.slope);
    long double next = time - now.value / now.slope;
    if (!(next > lower && next < upper && step < before / 2)) {
      if (step <= last_bit * time) break;
      step = (upper - lower) / 2;
      next = lower + step;
      if (next <= lower || next >= upper) break;
    }
    time = next;
    if (step <= last_bit * time) break;
    now = jet(time);
    ((now.value > 0) == (low > 0) ? lower : upper) = time;
  }
  return time;
}

}  // namespace ricochet::carrier_track::inline oracle
