#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <map>
#include <set>

#include "src/experiment/perturbations.h"
#include "tests/core/hessian_check.h"
#include "tests/experiment/perturbations/random_problem.h"

namespace ricochet {
namespace {

/// The place of each variable of the problem among those that are shown.
std::vector<Eigen::Index> places(const Problem& problem, const Problem& shown) {
  std::vector<Eigen::Index> result;
  for (const Variable& variable : problem.variables) {
    for (std::size_t k = 0; k < shown.variables.size(); ++k) {
      if (shown.variables[k].name == variable.name) result.push_back(static_cast<Eigen::Index>(k));
    }
  }
  return result;
}

/// What signed permutations must keep to the last bit; `to` takes vectors of the problem's own
/// coordinates to the shown ones.
void expect_same(const Problem& problem, const Problem& shown, const Matrix& to) {
  Random random(2);
  for (int k = 0; k < 20; ++k) {
    const Vector own = uniform_point(problem, random);
    const Vector x = to * own;
    EXPECT_TRUE((x.array() >= shown.lower.array()).all());
    EXPECT_TRUE((x.array() <= shown.upper.array()).all());
    EXPECT_EQ(shown.true_values(x).objective, true_values_at(problem, own).objective);
    EXPECT_EQ(shown.true_values(x).violation, true_values_at(problem, own).violation);
    const Derivatives d = shown.differentiate(x);
    const Derivatives own_d = problem.differentiate(own);
    EXPECT_EQ(shown.evaluate(x).objective, own_d.values.objective);
    EXPECT_EQ(d.values.constraints, own_d.values.constraints);
    EXPECT_EQ(d.gradient, to * own_d.gradient);
    EXPECT_EQ(d.jacobian, own_d.jacobian * to.transpose());
    EXPECT_EQ(shown.residuals(x).values, problem.residuals(own).values);
    EXPECT_EQ(shown.residuals(x).jacobian, problem.residuals(own).jacobian * to.transpose());
    const Vector multipliers = normal(problem.constraints, random);
    EXPECT_EQ(shown.lagrangian_hessian(x, 0.7, multipliers),
              to * problem.lagrangian_hessian(own, 0.7, multipliers) * to.transpose());
  }
  EXPECT_EQ(shown.start, to * problem.start);
  EXPECT_EQ(*shown.best_point, to * *problem.best_point);
  EXPECT_EQ(shown.best_known, problem.best_known);
  const Problem smooth = shown.smoothed(0.5);
  EXPECT_EQ(smooth.lower, shown.lower);
  EXPECT_EQ(smooth.start, shown.start);
  EXPECT_EQ(smooth.evaluate(shown.start).objective,
            problem.smoothed(0.5).evaluate(problem.start).objective);
}

TEST(Permuted, KeepsEverythingButTheOrder) {
  for (const Problem& problem : random_problems()) {
    const Eigen::Index n = problem.dimension();
    EXPECT_EQ(permuted().applies(problem), n > 1);
    if (n == 1) continue;
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const Problem shown = permuted().perturbed(problem, seed);
      const std::vector<Eigen::Index> place = places(problem, shown);
      ASSERT_EQ(static_cast<Eigen::Index>(place.size()), n);
      Matrix to = Matrix::Zero(n, n);
      for (Eigen::Index i = 0; i < n; ++i) {
        EXPECT_NE(place[static_cast<std::size_t>(i)], i);
        to(place[static_cast<std::size_t>(i)], i) = 1;
      }
      expect_same(problem, shown, to);
      EXPECT_EQ(places(problem, shown.smoothed(0.1)), place);
    }
  }
}

TEST(Permuted, DrawsEveryCycleAlike) {
  Random random(1);
  const Problem problem = random_problem(random, {.dimension = 4});
  std::map<std::vector<Eigen::Index>, int> drawn;
  constexpr int size = 6000;
  for (std::uint64_t seed = 0; seed < size; ++seed) {
    ++drawn[places(problem, permuted().perturbed(problem, seed))];
  }
  EXPECT_EQ(drawn.size(), 6U);  // (4 - 1)!
  for (const auto& [order, times] : drawn) EXPECT_NEAR(times, 1000, 5 * std::sqrt(1000 * 5 / 6.0));
}

TEST(Reflected, KeepsEverythingButTheSigns) {
  for (const Problem& problem : random_problems()) {
    EXPECT_TRUE(reflected().applies(problem));
    const Eigen::Index n = problem.dimension();
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const Problem shown = reflected().perturbed(problem, seed);
      Vector signs(n);
      for (Eigen::Index i = 0; i < n; ++i) signs[i] = shown.lower[i] == problem.lower[i] ? 1 : -1;
      EXPECT_LT(signs.minCoeff(), 0) << "one at least";
      expect_same(problem, shown, signs.asDiagonal());
      EXPECT_EQ(shown.variables[0].name, problem.variables[0].name);
    }
  }
}

TEST(Reflected, DrawsTheSignsAlike) {
  Random random(1);
  const Problem problem = random_problem(random, {.dimension = 3});
  std::map<std::vector<bool>, int> drawn;
  constexpr int size = 8000;
  for (std::uint64_t seed = 0; seed < size; ++seed) {
    const Problem shown = reflected().perturbed(problem, seed);
    std::vector<bool> reflections;
    for (Eigen::Index i = 0; i < 3; ++i) {
      reflections.push_back(shown.lower[i] != problem.lower[i]);
    }
    ++drawn[reflections];
  }
  EXPECT_EQ(drawn.size(), 7U);
  // Of k reflections: as drawn (1/8, then one of the k is named), or as k - 1 of them and the last
  // one named: k / 3 (1/8 + 1/8).
  for (const auto& [reflections, times] : drawn) {
    const double share =
        static_cast<double>(std::count(reflections.begin(), reflections.end(), true)) / 12;
    EXPECT_NEAR(times, share * size, 5 * std::sqrt(share * size));
  }
}

TEST(Rotated, AppliesWhereTheProblemMayBeTurned) {
  for (Problem problem : random_problems()) {
    EXPECT_EQ(rotated().applies(problem), problem.dimension() > 1);
    problem.rotates = false;
    EXPECT_FALSE(rotated().applies(problem));
  }
}

TEST(Rotated, KeepsTheValuesOfWhatIsTurnedWithIt) {
  Random random(1);
  for (const Problem& problem : random_problems()) {
    if (!rotated().applies(problem)) continue;
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const Problem shown = rotated().perturbed(problem, seed);
      const Vector& best = *problem.best_point;
      EXPECT_EQ(*shown.best_point, best);
      EXPECT_EQ(shown.true_values(best).objective, true_values_at(problem, best).objective);
      EXPECT_TRUE(shown.variables.empty());
      // What the box of the problem itself says of its start, the new one says of the turned one.
      EXPECT_NEAR((shown.start - best).norm(), (problem.start - best).norm(), 1e-12);
      EXPECT_NEAR(shown.evaluate(shown.start).objective, problem.evaluate(problem.start).objective,
                  1e-11);
      EXPECT_NEAR(shown.true_values(shown.start).objective,
                  true_values_at(problem, problem.start).objective, 1e-11);
      EXPECT_NEAR(shown.true_values(shown.start).violation,
                  true_values_at(problem, problem.start).violation, 1e-11);
      EXPECT_NEAR(shown.differentiate(shown.start).gradient.norm(),
                  problem.differentiate(problem.start).gradient.norm(), 1e-10);
      EXPECT_TRUE((shown.start.array() >= shown.lower.array()).all());
      EXPECT_TRUE((shown.start.array() <= shown.upper.array()).all());
      EXPECT_TRUE((shown.lower.array() <= problem.lower.array()).all());
      EXPECT_EQ(shown.smoothed(0.1).start, shown.start);
      EXPECT_NEAR(shown.smoothed(0.1).evaluate(shown.start).objective,
                  problem.smoothed(0.1).evaluate(problem.start).objective, 1e-11);
    }
  }
}

TEST(Rotated, HasDerivativesOfWhatItShows) {
  Random random(1);
  for (const Problem& problem : random_problems()) {
    if (!rotated().applies(problem)) continue;
    const Problem shown = rotated().perturbed(problem, 7);
    const Vector x = uniform_point(shown, random);
    const Derivatives d = shown.differentiate(x);
    const Residuals r = shown.residuals(x);
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const Vector step = 1e-5 * Vector::Unit(x.size(), i);
      const Values up = shown.evaluate(x + step);
      const Values down = shown.evaluate(x - step);
      const double scale = 1 + std::abs(d.gradient[i]);
      EXPECT_NEAR(d.gradient[i], (up.objective - down.objective) / 2e-5, 1e-6 * scale);
      for (Eigen::Index j = 0; j < problem.constraints; ++j) {
        EXPECT_NEAR(d.jacobian(j, i), (up.constraints[j] - down.constraints[j]) / 2e-5, 1e-6);
      }
    }
    EXPECT_LT((r.jacobian.transpose() * r.values - d.gradient).norm(),
              1e-11 * (1 + d.gradient.norm()));
    EXPECT_GT(expect_hessian_of_gradients(shown, x, 0.7, normal(problem.constraints, random)), 0);
    // At the best point: the same curvatures, but of other directions.
    const Vector none = Vector::Zero(problem.constraints);
    const Matrix own = problem.lagrangian_hessian(*problem.best_point, 1, none);
    const Matrix turned = shown.lagrangian_hessian(*problem.best_point, 1, none);
    const Eigen::SelfAdjointEigenSolver<Matrix> before(own);
    const Eigen::SelfAdjointEigenSolver<Matrix> after(turned);
    EXPECT_LT((before.eigenvalues() - after.eigenvalues()).norm(), 1e-11 * own.norm());
    EXPECT_GT((own - turned).norm(), 1e-3 * own.norm());
  }
}

}  // namespace
}  // namespace ricochet
