#pragma once

#include "ricochet/problem.h"
#include "ricochet/random.h"
#include "src/core/instance.h"
#include "tests/support/test.h"

namespace ricochet {

struct ProblemKind {
  Eigen::Index dimension = 3;
  Eigen::Index constraints = 0;
  Eigen::Index equalities = 0;
  bool own_true_values = false;  ///< whether the true objective is a function of its own
};

/// Random least squares with random quadratic constraints, all derivatives exact: with d = x - s,
/// residual k is a_k d + q_k d^2 / 2, constraint j is c_j d + p_j d^2 / 2 - e_j, where e_j is 0 for
/// an equality and positive for others. Its best point is s, also where it is turned. A smoothing
/// parameter w adds w d^2 / 2 to the objective.
inline Problem random_problem(Random& random, const ProblemKind& kind) {
  const Eigen::Index n = kind.dimension;
  const Eigen::Index m = n + 2;
  struct Data {
    Matrix a, c;
    Vector q, p, e, s;
    double smoothing = 0;
  };
  Data data{normal(m * n, random).reshaped(m, n),
            normal(kind.constraints * n, random).reshaped(kind.constraints, n),
            normal(m, random),
            normal(kind.constraints, random),
            normal(kind.constraints, random).cwiseAbs(),
            Vector(),
            0};
  data.e.head(kind.equalities).setZero();
  Problem problem;
  problem.name = "random";
  problem.lower = -1 - normal(n, random).array().abs();
  problem.upper = problem.lower.array() + 1 + normal(n, random).array().abs();
  problem.start = uniform_point(problem, random);
  data.s = uniform_point(problem, random);
  for (Eigen::Index i = 0; i < n; ++i) problem.variables.push_back({"v" + std::to_string(i), "mm"});
  problem.constraints = kind.constraints;
  problem.equalities = kind.equalities;
  problem.best_known = 0;
  problem.best_point = data.s;
  problem.rotates = true;

  const auto with_functions = [](Problem result, const Data& of) {
    result.residuals = [of](const Vector& x) {
      const Vector d = x - of.s;
      return Residuals{of.a * d + 0.5 * d.squaredNorm() * of.q, of.a + of.q * d.transpose()};
    };
    result.differentiate = [of, residuals = result.residuals](const Vector& x) {
      const Vector d = x - of.s;
      const double half_square = 0.5 * d.squaredNorm();
      const Residuals r = residuals(x);
      return Derivatives{{r.values.squaredNorm() / 2 + of.smoothing * half_square,
                          of.c * d + half_square * of.p - of.e},
                         r.jacobian.transpose() * r.values + of.smoothing * d,
                         of.c + of.p * d.transpose()};
    };
    result.evaluate = [differentiate = result.differentiate](const Vector& x) {
      return differentiate(x).values;
    };
    result.lagrangian_hessian = [of, residuals = result.residuals](const Vector& x, double factor,
                                                                   const Vector& multipliers) {
      const Residuals r = residuals(x);
      const double round = factor * (r.values.dot(of.q) + of.smoothing) + multipliers.dot(of.p);
      Matrix hessian = factor * r.jacobian.transpose() * r.jacobian;
      hessian.diagonal().array() += round;
      return Matrix(0.5 * (hessian + hessian.transpose()));
    };
    return result;
  };

  Problem judged = with_functions(problem, data);
  const auto true_values = [evaluate = judged.evaluate, equalities = kind.equalities](
                               const Vector& x) { return true_values_of(evaluate(x), equalities); };
  if (kind.own_true_values) judged.true_values = true_values;
  judged.smoothed = [problem, data, true_values, with_functions](double smoothing) {
    Data wide = data;
    wide.smoothing = smoothing;
    Problem smooth = with_functions(problem, wide);
    smooth.true_values = true_values;
    return smooth;
  };
  return judged;
}

/// Of all kinds: with and without constraints, equalities, a true objective of their own; 1 to 6
/// variables.
inline std::vector<Problem> random_problems() {
  Random random(1);
  std::vector<Problem> problems;
  for (const Eigen::Index n : {1, 2, 3, 6}) {
    for (const bool own_true_values : {false, true}) {
      for (const auto& [constraints, equalities] : {std::pair{0, 0}, {2, 0}, {3, 2}, {1, 1}}) {
        problems.push_back(random_problem(random, {n, constraints, equalities, own_true_values}));
      }
    }
  }
  return problems;
}

/// Everything that a problem tells a solver at a point, the values as they come with derivatives.
/// What the problem has not is empty.
struct Told {
  double objective = 0;
  Vector constraints, gradient, residuals;
  Matrix jacobian, jacobian_of_residuals, hessian;

  bool operator==(const Told&) const = default;

  /// All its numbers in a row; of the Hessian the upper half.
  std::vector<double> numbers() const {
    std::vector<double> all = {objective};
    const auto add = [&all](const auto& list) {
      for (const double number : list.reshaped()) all.push_back(number);
    };
    add(constraints), add(gradient), add(residuals), add(jacobian), add(jacobian_of_residuals);
    for (Eigen::Index j = 0; j < hessian.cols(); ++j) add(hessian.col(j).head(j + 1));
    return all;
  }
};

inline void PrintTo(const Told& told, std::ostream* stream) {
  for (const double number : told.numbers()) *stream << number << ' ';
}

inline Told told_at(const Problem& problem, const Vector& x, double factor,
                    const Vector& multipliers) {
  const Derivatives d = problem.differentiate(x);
  const Residuals r = problem.residuals ? problem.residuals(x) : Residuals();
  return {d.values.objective,
          d.values.constraints,
          d.gradient,
          r.values,
          d.jacobian,
          r.jacobian,
          problem.lagrangian_hessian(x, factor, multipliers)};
}

inline Told told_at(const Problem& problem, const Vector& x) {
  return told_at(problem, x, 1, Vector::Ones(problem.constraints));
}

inline bool operator==(const Values& a, const Values& b) {
  return a.objective == b.objective && a.constraints == b.constraints;
}
inline bool operator==(const TrueValues& a, const TrueValues& b) {
  return a.objective == b.objective && a.violation == b.violation;
}

inline bool is_inside(const Problem& problem, const Vector& x) {
  return (x.array() >= problem.lower.array()).all() && (x.array() <= problem.upper.array()).all();
}

}  // namespace ricochet
