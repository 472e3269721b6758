#pragma once

#include <ceres/jet.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "problems/carrier_track/gradients/trust.h"

/// Exact derivatives, by dual numbers, of a value that is computed from simulations and depends on
/// some variables. A Function is called with the variables and with a watcher of every simulation,
/// and works for every scalar type:
///
///   template <class Scalar, class Watch>
///   Scalar operator()(std::span<const Scalar> x, Watch& watch) const;
///
/// It passes `watch.of(scene)` as an observer to every simulation that the value depends on. A
/// Function of a problem defines `static constexpr int jet_size`, the number of directions to
/// differentiate at a time: the number of variables. For the shape of a speed profile, which may
/// have any number of variables, see shape_derivatives.h.
namespace ricochet::carrier_track::inline gradients {

/// Watches nothing.
struct Unwatched {
  template <class Scalar>
  Observer of(const BasicScene<Scalar>& /*scene*/) {
    return {};
  }
};

/// The value at x.
template <class Function>
double value_of(const Function& f, const Vector& x) {
  Unwatched nobody;
  return f(std::span<const double>(x.data(), static_cast<std::size_t>(x.size())), nobody);
}

struct Gradient {
  double value;
  Vector gradient;  ///< length n
  Trust trust;
};

struct Hessian {
  double value;
  Vector gradient;  ///< length n
  Matrix hessian;   ///< n x n, symmetric
};

namespace detail {

/// The variables as duals; each variable from `first` on has a direction.
template <class Jet>
std::vector<Jet> seeded(const Vector& x, Eigen::Index first) {
  std::vector<Jet> duals;
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Jet dual(x[i]);
    if (i >= first && i < first + Jet::DIMENSION) dual.v[i - first] = 1.0;
    duals.push_back(dual);
  }
  return duals;
}

}  // namespace detail

/// Value and gradient at x, and their trust in a box of these `widths` (length n). Differentiates
/// `Room` directions at a time.
template <int Room = 5, class Function>
Gradient gradient_of(const Function& f, const Vector& x, const Vector& widths) {
  using Jet = ceres::Jet<double, Room>;
  Gradient result{0, Vector(x.size()), {}};
  double steepest = 0;
  double growth = 0;
  for (Eigen::Index first = 0; first < x.size(); first += Room) {
    const std::vector<Jet> duals = detail::seeded<Jet>(x, first);
    TrustGauge<Jet> gauge(widths, first);
    const Jet y = f(std::span<const Jet>(duals), gauge);
    result.value = y.a;
    const Eigen::Index size = std::min<Eigen::Index>(Room, x.size() - first);
    for (Eigen::Index i = 0; i < size; ++i) result.gradient[first + i] = y.v[i];
    steepest += gauge.steepest() * gauge.steepest();
    growth += gauge.growth() * gauge.growth();
  }
  result.trust = trust_of(steepest, growth, result.gradient.cwiseProduct(widths).norm());
  return result;
}

namespace detail {

/// The block of second derivatives from row `row` and column `column` on, with value and gradient.
template <int Room, class Function>
void hessian_block(const Function& f, const Vector& x, Eigen::Index row, Eigen::Index column,
                   Hessian& result) {
  using Jet = ceres::Jet<double, Room>;
  using Second = ceres::Jet<Jet, Room>;
  std::vector<Second> duals;
  const std::vector<Jet> columns = seeded<Jet>(x, column);
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    Second dual(columns[static_cast<std::size_t>(i)]);
    if (i >= row && i < row + Room) dual.v[i - row] = Jet(1.0);
    duals.push_back(dual);
  }
  Unwatched nobody;
  const Second y = f(std::span<const Second>(duals), nobody);
  result.value = y.a.a;
  for (Eigen::Index i = row; i < std::min(row + Room, x.size()); ++i) {
    result.gradient[i] = y.v[i - row].a;
    for (Eigen::Index j = std::max(i, column); j < std::min(column + Room, x.size()); ++j) {
      result.hessian(i, j) = result.hessian(j, i) = y.v[i - row].v[j - column];
    }
  }
}

}  // namespace detail

/// Value, gradient and second derivatives at x, in blocks of `Room` by `Room` directions. Measured:
/// Room = 1 is the fastest for one variable, 2 for up to six.
template <int Room = 2, class Function>
Hessian hessian_of(const Function& f, const Vector& x) {
  Hessian result{0, Vector(x.size()), Matrix(x.size(), x.size())};
  for (Eigen::Index row = 0; row < x.size(); row += Room) {
    for (Eigen::Index column = row; column < x.size(); column += Room) {
      detail::hessian_block<Room>(f, x, row, column, result);
    }
  }
  return result;
}

}  // namespace ricochet::carrier_track::inline gradients
