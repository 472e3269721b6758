#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

/// Derivatives by differences, as good as they can be had: what exact ones are held against.
namespace ricochet::studies::surrogate {

struct Difference {
  double slope = 0;
  double error = std::numeric_limits<double>::infinity();  ///< estimated
};

/// Extrapolates the central differences of steps h, h/2, h/4, ... to step 0, where the
/// extrapolations agree best (Ridders 1982, doi 10.1016/S0141-1195(82)80057-0).
class Extrapolation {
 public:
  static constexpr std::size_t levels = 12;

  /// The next of the central differences, of which there are `levels` at most.
  void add(double central) {
    auto& row = table_[size_];
    row[0] = central;
    double factor = 4;
    for (std::size_t k = 1; k <= size_; ++k, factor *= 4) {
      const double before = table_[size_ - 1][k - 1];
      row[k] = row[k - 1] + (row[k - 1] - before) / (factor - 1);
      const double error = std::max(std::abs(row[k] - row[k - 1]), std::abs(row[k] - before));
      if (error < best_.error) best_ = {row[k], error};
    }
    ++size_;
  }

  const Difference& best() const { return best_; }

 private:
  std::array<std::array<double, levels>, levels> table_{};
  std::size_t size_ = 0;
  Difference best_;
};

/// Slope of f at x, from steps h and less.
template <class Function>
Difference difference(Function f, double x, double h) {
  Extrapolation extrapolation;
  for (std::size_t i = 0; i < Extrapolation::levels; ++i, h /= 2) {
    extrapolation.add((f(x + h) - f(x - h)) / (2 * h));
  }
  return extrapolation.best();
}

}  // namespace ricochet::studies::surrogate
