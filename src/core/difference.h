#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

#include "ricochet/problem.h"

/// Accurate derivatives by extrapolated differences: the reference for exact derivatives.
namespace ricochet {

struct Difference {
  double slope = 0;
  double error = std::numeric_limits<double>::infinity();  ///< estimated
};

/// Extrapolates slopes over steps h, h/2, h/4, ..., whose errors are a series in h^order, to step 0
/// and returns the value where the extrapolations agree best (Ridders 1982, doi
/// 10.1016/S0141-1195(82)80057-0). The order is 1, or 2 for central differences.
template <class Number = double>
class Extrapolation {
 public:
  /// Largest number of steps; fewer are enough where rounding errors are small.
  static constexpr std::size_t levels = std::is_same_v<Number, double> ? 12 : 7;

  explicit Extrapolation(int order = 2) : first_(order == 1 ? 2 : 4) {}

  void add(Number slope) {
    auto& row = table_[size_];
    row[0] = slope;
    Number factor = first_;
    for (std::size_t k = 1; k <= size_; ++k, factor *= first_) {
      const Number before = table_[size_ - 1][k - 1];
      row[k] = row[k - 1] + (row[k - 1] - before) / (factor - 1);
      const auto error =
          static_cast<double>(std::max(std::abs(row[k] - row[k - 1]), std::abs(row[k] - before)));
      if (error < best_.error) best_ = {static_cast<double>(row[k]), error};
    }
    ++size_;
  }

  const Difference& best() const { return best_; }

 private:
  Number first_;
  std::array<std::array<Number, levels>, levels> table_{};
  std::size_t size_ = 0;
  Difference best_;
};

/// Slope of f at x by central differences of step h and smaller.
template <class Function, class Number>
Difference difference(Function f, Number x, Number h) {
  Extrapolation<Number> extrapolation;
  for (std::size_t i = 0; i < extrapolation.levels; ++i, h /= 2) {
    extrapolation.add((f(x + h) - f(x - h)) / (2 * h));
  }
  return extrapolation.best();
}

/// Slope of f at x by one-sided differences, on the side given by the sign of h.
template <class Function, class Number>
Difference one_sided_difference(Function f, Number x, Number h) {
  Extrapolation<Number> extrapolation(1);
  const Number here = f(x);
  for (std::size_t i = 0; i < extrapolation.levels; ++i, h /= 2) {
    extrapolation.add((f(x + h) - here) / h);
  }
  return extrapolation.best();
}

/// Slopes at x of all entries of an f that returns vectors, by central differences.
template <class Function>
std::vector<Difference> differences(Function f, double x, double h) {
  std::vector<Extrapolation<>> entries;
  for (std::size_t i = 0; i < Extrapolation<>::levels; ++i, h /= 2) {
    const Vector central = (f(x + h) - f(x - h)) / (2 * h);
    entries.resize(static_cast<std::size_t>(central.size()));
    for (std::size_t k = 0; k < entries.size(); ++k) {
      entries[k].add(central[static_cast<Eigen::Index>(k)]);
    }
  }
  std::vector<Difference> best;
  for (const Extrapolation<>& entry : entries) best.push_back(entry.best());
  return best;
}

}  // namespace ricochet
