#pragma once

#include <ceres/jet.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "problems/carrier_track/impact_model.h"
#include "src/core/problem.h"

/// Exact derivatives, by dual numbers, of anything that is computed from simulations and depends on
/// some variables. A Function is called with the variables and with somebody who watches every
/// simulation, and works for every scalar type:
///
///   template <class Scalar, class Watch>
///   Scalar operator()(std::span<const Scalar> x, Watch& watch) const;
///
/// It lets `watch.of(scene)`, an observer, see every simulation that the value depends on.
namespace ricochet::carrier_track {

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

/// The variables as duals, those from `first` on with a direction of their own.
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

template <int Room, class Function>
Gradient gradient_in_blocks(const Function& f, const Vector& x) {
  using Jet = ceres::Jet<double, Room>;
  Gradient result{0, Vector(x.size()), {}};
  Unwatched nobody;
  for (Eigen::Index first = 0; first < x.size(); first += Room) {
    const std::vector<Jet> duals = seeded<Jet>(x, first);
    const Jet y = f(std::span<const Jet>(duals), nobody);
    result.value = y.a;
    const Eigen::Index size = std::min<Eigen::Index>(Room, x.size() - first);
    result.gradient.segment(first, size) = y.v.head(size);
  }
  return result;
}

}  // namespace detail

/// Value and gradient at x, and how far to trust them in a box of these `widths` (length n).
template <class Function>
Gradient gradient_of(const Function& f, const Vector& x, const Vector& /*widths*/) {
  if (x.size() == 1) return detail::gradient_in_blocks<1>(f, x);
  if (x.size() <= 4) return detail::gradient_in_blocks<4>(f, x);
  return detail::gradient_in_blocks<16>(f, x);
}

}  // namespace ricochet::carrier_track
