#pragma once

#include <ceres/jet.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "problems/classic/hyper_dual.h"
#include "ricochet/problem.h"

/// Problems from formulas. A formula is written once, for every scalar type:
///
///   []<class Scalar>(const Point<Scalar>& x) { return x[0] * x[0] + sin(x[1]); }
///
/// and yields one Scalar, or several as a std::array or a Point of them. Its exact derivatives come
/// from dual numbers, the second ones from hyper-dual numbers.
namespace ricochet::classic {

template <class Scalar>
using Point = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;

/// How the provenance of a best value begins that is proven.
inline constexpr const char* closed_form = "closed form";

/// A problem without its formulas; see Problem.
struct Statement {
  std::string name = {};
  std::string source = {};
  Vector lower = {}, upper = {};
  Vector start = {};  ///< projected onto the box
  double best_known = 0;
  Vector best_point = {};
  std::string provenance = {};
  bool rotates = false;
  std::vector<double> start_scales = {};  ///< see Problem
  std::string cluster = {};               ///< see Problem
};

/// The problem without its functions.
Problem without_functions(Statement statement);

namespace detail {

template <class Scalar>
Point<Scalar> listed(const Scalar& value) {
  return Point<Scalar>::Constant(1, value);
}

template <class Scalar>
Point<Scalar> listed(const Point<Scalar>& values) {
  return values;
}

template <class Scalar, std::size_t count>
Point<Scalar> listed(const std::array<Scalar, count>& values) {
  return Eigen::Map<const Point<Scalar>>(values.data(), static_cast<Eigen::Index>(count));
}

/// The values of `formula` at x, in order.
template <class Formula>
Vector values_of(const Formula& formula, const Vector& x) {
  return listed(formula(x));
}

/// The derivatives of the values of `formula` at x: values x n.
template <class Formula>
Matrix jacobian_of(const Formula& formula, const Vector& x) {
  constexpr int block = 4;  // directions per pass
  using Jet = ceres::Jet<double, block>;
  const Eigen::Index n = x.size();
  Matrix jacobian;
  for (Eigen::Index first = 0; first < n; first += block) {
    const Eigen::Index size = std::min<Eigen::Index>(block, n - first);
    Point<Jet> duals(n);
    for (Eigen::Index i = 0; i < n; ++i) duals[i] = Jet(x[i]);
    for (Eigen::Index i = 0; i < size; ++i) duals[first + i].v[i] = 1.0;
    const Point<Jet> y = listed(formula(duals));
    if (first == 0) jacobian.resize(y.size(), n);
    for (Eigen::Index row = 0; row < y.size(); ++row) {
      jacobian.block(row, first, 1, size) = y[row].v.head(size).transpose();
    }
  }
  return jacobian;
}

/// Adds to `sum` the second derivatives at x of the values of `formula`, each times its weight.
template <class Formula>
void add_curvature(const Formula& formula, const Vector& x, const Vector& weights, Matrix& sum) {
  Point<HyperDual> duals(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) duals[i] = x[i];
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    duals[i].first = 1;
    for (Eigen::Index j = 0; j <= i; ++j) {
      duals[j].other = 1;
      const Point<HyperDual> y = listed(formula(duals));
      double mixed = 0;
      for (Eigen::Index k = 0; k < y.size(); ++k) {
        if (weights[k] != 0) mixed += weights[k] * y[k].mixed;
      }
      sum(i, j) += mixed;
      if (j < i) sum(j, i) += mixed;
      duals[j].other = 0;
    }
    duals[i].first = 0;
  }
}

}  // namespace detail

/// Minimise `objective` subject to all `constraints` <= 0.
template <class Objective, class Constraints>
Problem from_formulas(Statement statement, const Objective& objective,
                      const Constraints& constraints) {
  Problem problem = without_functions(std::move(statement));
  problem.constraints = detail::values_of(constraints, problem.start).size();
  problem.evaluate = [objective, constraints](const Vector& x) {
    return Values{objective(x), detail::values_of(constraints, x)};
  };
  problem.differentiate = [objective, constraints](const Vector& x) {
    return Derivatives{{objective(x), detail::values_of(constraints, x)},
                       detail::jacobian_of(objective, x).row(0).transpose(),
                       detail::jacobian_of(constraints, x)};
  };
  problem.lagrangian_hessian = [objective, constraints](const Vector& x, double objective_factor,
                                                        const Vector& multipliers) {
    Matrix hessian = Matrix::Zero(x.size(), x.size());
    detail::add_curvature(objective, x, Vector::Constant(1, objective_factor), hessian);
    detail::add_curvature(constraints, x, multipliers, hessian);
    return hessian;
  };
  return problem;
}

/// Minimise `objective`.
template <class Objective>
Problem from_formula(Statement statement, const Objective& objective) {
  Problem problem = without_functions(std::move(statement));
  problem.evaluate = [objective](const Vector& x) { return Values{objective(x), {}}; };
  problem.differentiate = [objective](const Vector& x) {
    return Derivatives{{objective(x), {}},
                       detail::jacobian_of(objective, x).row(0).transpose(),
                       Matrix(0, x.size())};
  };
  problem.lagrangian_hessian = [objective](const Vector& x, double objective_factor,
                                           const Vector& /*multipliers*/) {
    Matrix hessian = Matrix::Zero(x.size(), x.size());
    detail::add_curvature(objective, x, Vector::Constant(1, objective_factor), hessian);
    return hessian;
  };
  return problem;
}

/// Minimise half the sum of the squares of `residuals`.
template <class Formula>
Problem from_residuals(Statement statement, const Formula& residuals) {
  Problem problem = without_functions(std::move(statement));
  problem.evaluate = [residuals](const Vector& x) {
    return Values{detail::values_of(residuals, x).squaredNorm() / 2, {}};
  };
  problem.residuals = [residuals](const Vector& x) {
    return Residuals{detail::values_of(residuals, x), detail::jacobian_of(residuals, x)};
  };
  problem.differentiate = [both = problem.residuals](const Vector& x) {
    const Residuals r = both(x);
    return Derivatives{
        {r.values.squaredNorm() / 2, {}}, r.jacobian.transpose() * r.values, Matrix(0, x.size())};
  };
  problem.lagrangian_hessian = [residuals](const Vector& x, double objective_factor,
                                           const Vector& /*multipliers*/) {
    const Matrix jacobian = detail::jacobian_of(residuals, x);
    Matrix hessian = objective_factor * jacobian.transpose() * jacobian;
    detail::add_curvature(residuals, x, objective_factor * detail::values_of(residuals, x),
                          hessian);
    return hessian;
  };
  return problem;
}

/// The Lagrange multipliers of the constraints at the best known point, of length
/// Problem::constraints: at least 0 for inequalities, and 0 for those that are not active. The
/// gradient of the objective plus the constraints' times their multipliers is 0, apart from what
/// the active bounds of the box balance. Where several multipliers do this, these are one choice.
/// Nothing if none do. The problem must have derivatives and a best known point.
std::optional<Vector> multipliers_at_best(const Problem& problem);

}  // namespace ricochet::classic
