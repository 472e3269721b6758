#pragma once

#include "ricochet/evaluator.h"
#include "ricochet/problem.h"
#include "solvers/scaled_box.h"
#include "tests/support/test.h"

/// Calls of the libraries' own interfaces, as a caller without ricochet's adapters writes them.
namespace ricochet {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// A call of a library for one problem, in the problem's own coordinates or, of NLopt and Ceres's
/// trust region, in those of the unit cube: x = origin + scale u.
struct DirectCall {
  const Problem& problem;
  Evaluator& evaluator;  ///< charges what the library asks; beyond all limits of the library
  Coordinates coordinates = Coordinates::own;
  std::uint64_t seed = 0;
  int limit = 0;  ///< the library's own: of evaluations (NLopt, dlib, TAO), of iterations (Ipopt,
                  ///< Ceres), of evaluations rounded up to generations (pagmo)
  /// The library's own choices where the adapter gives a reason for none of its own: NLopt's first
  /// step and length of history, Ceres's L-BFGS without bounds.
  bool library_chooses = false;

  bool in_unit_cube() const { return coordinates == Coordinates::unit; }
  Vector width() const { return problem.upper - problem.lower; }
  Vector origin() const { return in_unit_cube() ? problem.lower : Vector(0 * problem.lower); }
  Vector scale() const { return in_unit_cube() ? width() : Vector::Ones(problem.dimension()); }
  Vector at(const double* u) const { return x(Eigen::Map<const Vector>(u, problem.dimension())); }
  Vector x(const Vector& u) const { return origin() + scale().cwiseProduct(u); }
  Vector u(const Vector& x) const { return (x - origin()).cwiseQuotient(scale()); }
};

Vector call_ipopt(const std::string& solver, const DirectCall& call);
Vector call_pagmo(const std::string& solver, const DirectCall& call);

/// The call of this solver's library; it returns the point x that the library returns. Empty for a
/// solver that is ricochet's own.
std::function<Vector(const DirectCall&)> direct_call(const std::string& solver);

/// The coordinates in which the adapter of this solver calls its library.
Coordinates coordinates_of(const std::string& solver);

}  // namespace ricochet
