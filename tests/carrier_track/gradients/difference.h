#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace ricochet::carrier_track {

struct Difference {
  double slope;
  double error;  ///< estimated
};

/// Slope at step 0 from slope(h), slope(h / 2), ... whose errors are a series in h^order, where the
/// extrapolations agree best (Ridders 1982).
template <class Number, class SlopeOver>
Difference extrapolated_slope(SlopeOver slope, Number h, int order) {
  // Where rounding is far away, fewer steps do.
  constexpr std::size_t levels = std::is_same_v<Number, double> ? 12 : 7;
  std::array<std::array<Number, levels>, levels> table{};
  Difference best{0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < levels; ++i, h /= 2) {
    table[i][0] = slope(h);
    const Number first = order == 1 ? 2 : 4;
    Number factor = first;
    for (std::size_t k = 1; k <= i; ++k, factor *= first) {
      table[i][k] = table[i][k - 1] + (table[i][k - 1] - table[i - 1][k - 1]) / (factor - 1);
      const auto error = static_cast<double>(std::max(std::abs(table[i][k] - table[i][k - 1]),
                                                      std::abs(table[i][k] - table[i - 1][k - 1])));
      if (error < best.error) best = {static_cast<double>(table[i][k]), error};
    }
  }
  return best;
}

/// Slope of f at x by central differences of steps h, h/2, ...
template <class Function, class Number>
Difference difference(Function f, Number x, Number h) {
  return extrapolated_slope<Number>(
      [&](Number step) { return (f(x + step) - f(x - step)) / (2 * step); }, h, 2);
}

/// The same by differences to one side, that of h.
template <class Function, class Number>
Difference one_sided_difference(Function f, Number x, Number h) {
  const Number here = f(x);
  return extrapolated_slope<Number>([&](Number step) { return (f(x + step) - here) / step; }, h, 1);
}

}  // namespace ricochet::carrier_track
