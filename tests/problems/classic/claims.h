#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "ricochet/run.h"
#include "src/core/difference.h"
#include "src/core/instance.h"

/// What every problem of a list must fulfil.
namespace ricochet::classic {

/// The problem of this name.
inline Problem named(const std::vector<Problem>& problems, const std::string& name) {
  const auto found = std::find_if(problems.begin(), problems.end(),
                                  [&](const Problem& problem) { return problem.name == name; });
  if (found == problems.end()) throw std::invalid_argument("no problem " + name);
  return *found;
}

/// The best point attains the best value, and lies in the box and in the constraints; the box and
/// the start are finite, and the texts are there.
inline void expect_statement(const Problem& problem) {
  SCOPED_TRACE(problem.name);
  EXPECT_FALSE(problem.source.empty());
  EXPECT_FALSE(problem.provenance.empty());
  ASSERT_TRUE(problem.best_known && problem.best_point);
  const Vector& best = *problem.best_point;
  for (const Vector* x : {&problem.lower, &problem.upper, &problem.start, &best}) {
    ASSERT_EQ(x->size(), problem.dimension());
    EXPECT_TRUE(x->allFinite());
    EXPECT_TRUE((x->array() >= problem.lower.array()).all());
    EXPECT_TRUE((x->array() <= problem.upper.array()).all());
  }
  EXPECT_TRUE((problem.upper.array() > problem.lower.array()).all());
  const Values values = problem.evaluate(best);
  EXPECT_NEAR(values.objective, *problem.best_known, 1e-11 * std::abs(*problem.best_known) + 1e-20);
  EXPECT_EQ(values.constraints.size(), problem.constraints);
  EXPECT_EQ(true_values_at(problem, best).violation, 0);
  if (problem.equalities > 0) {
    const Matrix jacobian = problem.differentiate(best).jacobian.topRows(problem.equalities);
    const Vector terms = jacobian.cwiseAbs() * best.cwiseAbs();  // they cancel
    EXPECT_TRUE((values.constraints.head(problem.equalities).cwiseAbs().array() <=
                 1e-15 * terms.array().max(1000))
                    .all())
        << values.constraints.head(problem.equalities).transpose();
  }
  if (problem.rotates) {
    EXPECT_TRUE((best.array() > problem.lower.array()).all());
    EXPECT_TRUE((best.array() < problem.upper.array()).all());
  }
}

/// No random point of the problem, of 1000, and of its first instances, of 200 each, is feasible
/// and better than the best.
inline void expect_nothing_better(const Problem& problem) {
  SCOPED_TRACE(problem.name);
  Random random(seed_of(problem.name, "points", 0, 0));
  for (int number = 0; number <= 3; ++number) {
    const Problem moved = instance(problem, number);
    const int points = number == 0 ? 1000 : 200;
    for (int i = 0; i < points; ++i) {
      const TrueValues true_values = true_values_at(moved, uniform_point(moved, random));
      if (true_values.violation > 0) continue;
      ASSERT_GE(true_values.objective, *problem.best_known - 1e-9);
    }
  }
}

/// The first instances have the best value at their own best point, turned or not, but for a
/// rounding of each coordinate.
inline void expect_best_in_instances(const Problem& problem) {
  SCOPED_TRACE(problem.name);
  double objective_off = 1e-9 * std::max(1.0, std::abs(*problem.best_known));
  double constraints_off = 1e-9;
  if (problem.differentiate) {
    const Derivatives d = problem.differentiate(*problem.best_point);
    const Vector rounding = 4e-15 * (problem.upper - problem.lower);
    objective_off += d.gradient.cwiseAbs().dot(rounding);
    if (problem.constraints > 0) constraints_off += (d.jacobian.cwiseAbs() * rounding).maxCoeff();
  }
  for (int number = 1; number <= 3; ++number) {
    const Problem moved = instance(problem, number);
    const TrueValues true_values = true_values_at(moved, *moved.best_point);
    EXPECT_NEAR(true_values.objective, *problem.best_known, objective_off);
    EXPECT_LE(true_values.violation, constraints_off);
  }
}

/// Objective and constraints as one vector.
inline Vector all_of(const Values& values) {
  Vector all(1 + values.constraints.size());
  all << values.objective, values.constraints;
  return all;
}

/// A random point of the box, a tenth as far from the best point as the box reaches: beyond, some
/// values are so large that differences of them are none.
inline Vector point_near_best(const Problem& problem, Random& random) {
  return 0.9 * *problem.best_point + 0.1 * uniform_point(problem, random);
}

/// The columns of a Jacobian agree with differences of the function, to `tolerance` of the column's
/// largest entry, and to what rounding of the function leaves of them.
template <class Function>
void expect_columns(const Problem& problem, const Vector& x, const Matrix& jacobian,
                    Function function, double tolerance) {
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const auto along = [&](double t) -> Vector {
      Vector moved = x;
      moved[i] = t;
      return function(moved);
    };
    const double width = problem.upper[i] - problem.lower[i];
    Vector found(jacobian.rows());
    for (Eigen::Index k = 0; const Difference& d : differences(along, x[i], 1e-3 * width)) {
      found[k++] = d.slope;
    }
    const double size = std::max(jacobian.col(i).cwiseAbs().maxCoeff(), 1e-12);
    const double rounding = 1e-12 * function(x).cwiseAbs().maxCoeff() / width;
    EXPECT_LE((jacobian.col(i) - found).cwiseAbs().maxCoeff(), tolerance * size + rounding)
        << "column " << i << "\n"
        << jacobian.col(i).transpose() << "\n"
        << found.transpose();
  }
}

inline void expect_derivatives(const Problem& problem, double tolerance) {
  SCOPED_TRACE(problem.name);
  Random random(seed_of(problem.name, "derivatives", 0, 0));
  for (int i = 0; i < 3; ++i) {
    const Vector x = point_near_best(problem, random);
    const Derivatives d = problem.differentiate(x);
    EXPECT_EQ(all_of(d.values), all_of(problem.evaluate(x)));
    Matrix rows(1 + problem.constraints, problem.dimension());
    rows << d.gradient.transpose(), d.jacobian;
    expect_columns(
        problem, x, rows.topRows(1),
        [&](const Vector& y) { return all_of(problem.evaluate(y)).head(1).eval(); }, tolerance);
    if (problem.constraints == 0) continue;
    expect_columns(
        problem, x, d.jacobian, [&](const Vector& y) { return problem.evaluate(y).constraints; },
        tolerance);
  }
}

}  // namespace ricochet::classic
