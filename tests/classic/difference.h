#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "src/core/problem.h"

namespace ricochet::classic {

struct Difference {
  Vector value;
  Vector error;  ///< estimated
};

/// The derivatives at t of a function from a number to a vector, by central differences of widths
/// from h down, extrapolated: of every entry the extrapolation that agrees best with its neighbours
/// (Ridders 1982, doi 10.1016/S0141-1195(82)80057-0).
template <class Function>
Difference difference(Function f, double t, double h) {
  constexpr std::size_t levels = 14;
  std::array<std::array<Vector, levels>, levels> table;
  Difference best;
  for (std::size_t i = 0; i < levels; ++i, h /= 2) {
    table[i][0] = (f(t + h) - f(t - h)) / (2 * h);
    if (i == 0) {
      best = {table[0][0],
              Vector::Constant(table[0][0].size(), std::numeric_limits<double>::infinity())};
    }
    double factor = 4;
    for (std::size_t k = 1; k <= i; ++k, factor *= 4) {
      table[i][k] = table[i][k - 1] + (table[i][k - 1] - table[i - 1][k - 1]) / (factor - 1);
      for (Eigen::Index entry = 0; entry < best.value.size(); ++entry) {
        const double now = table[i][k][entry];
        const double error = std::max(std::abs(now - table[i][k - 1][entry]),
                                      std::abs(now - table[i - 1][k - 1][entry]));
        if (error < best.error[entry]) {
          best.value[entry] = now;
          best.error[entry] = error;
        }
      }
    }
  }
  return best;
}

}  // namespace ricochet::classic
