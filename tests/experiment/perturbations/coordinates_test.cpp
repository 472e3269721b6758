#include <Eigen/Eigenvalues>

#include "ricochet/run.h"
#include "src/experiment/perturbations.h"
#include "tests/core/hessian_check.h"
#include "tests/experiment/perturbations/random_problem.h"

namespace ricochet {
namespace {

TEST(PerturbedStart, LiesAThousandthOfTheBoxAwayAndInside) {
  for (Problem problem : random_problems()) {
    const Vector width = problem.upper - problem.lower;
    for (const Vector& start : {Vector(problem.start), problem.lower, problem.upper}) {
      problem.start = start;
      for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Problem moved = perturbed_start().perturbed(problem, seed);
        EXPECT_NEAR((moved.start - start).cwiseQuotient(width).norm(), 1e-3, 1e-12);
        EXPECT_TRUE(is_inside(problem, moved.start));
        EXPECT_EQ(moved.evaluate(start).objective, problem.evaluate(start).objective);
      }
    }
  }
}

TEST(PerturbedStart, HasNoPreferredDirection) {
  Random random(1);
  const Problem problem = random_problem(random, {.dimension = 3});
  const Vector width = problem.upper - problem.lower;
  constexpr int size = 20'000;
  Matrix moments = Matrix::Zero(3, 3);
  Vector mean = Vector::Zero(3);
  for (std::uint64_t seed = 0; seed < size; ++seed) {
    const Problem moved = perturbed_start().perturbed(problem, seed);
    const Vector direction = 1e3 * (moved.start - problem.start).cwiseQuotient(width);
    mean += direction / size;
    moments += direction * direction.transpose() / size;
  }
  EXPECT_LT(mean.cwiseAbs().maxCoeff(), 5 * std::sqrt(1.0 / 3 / size));
  EXPECT_LT((moments - Matrix::Identity(3, 3) / 3).cwiseAbs().maxCoeff(),
            5 * 0.3 / std::sqrt(size));
}

TEST(PerturbedStart, IsWhereEveryRunBegins) {
  Random random(1);
  const Problem problem = random_problem(random, {});
  for (const int number : {0, 1, 2}) {
    const Problem moved = perturbed_start().perturbed(problem, static_cast<std::uint64_t>(number));
    std::vector<Vector> starts;
    Solver solver;
    solver.solve = [&](Evaluator& evaluator, const Vector& start, Random&) {
      starts.push_back(start);
      evaluator.values(start);
      return SolverTermination{};
    };
    run(moved, solver, {2}, number);
    EXPECT_EQ(starts.at(0), moved.start) << number;
    EXPECT_GT((starts.at(1) - moved.start).norm(), 0.01) << "the solver's second start";
  }
}

/// The place of each variable of the problem among those that are shown.
std::vector<Eigen::Index> places(const Problem& problem, const Problem& shown) {
  std::vector<Eigen::Index> result;
  for (const Variable& variable : problem.variables) {
    const auto found = std::ranges::find(shown.variables, variable.name, &Variable::name);
    result.push_back(found - shown.variables.begin());
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
    EXPECT_TRUE(is_inside(shown, x));
    EXPECT_EQ(shown.true_values(x), true_values_at(problem, own));
    EXPECT_EQ(shown.evaluate(x), problem.evaluate(own));
    const Vector multipliers = normal(problem.constraints, random);
    Told expected = told_at(problem, own, 0.7, multipliers);
    expected.gradient = to * expected.gradient;
    expected.jacobian = expected.jacobian * to.transpose();
    expected.jacobian_of_residuals = expected.jacobian_of_residuals * to.transpose();
    expected.hessian = to * expected.hessian * to.transpose();
    EXPECT_EQ(told_at(shown, x, 0.7, multipliers), expected);
  }
  EXPECT_EQ(shown.start, to * problem.start);
  EXPECT_EQ(*shown.best_point, to * *problem.best_point);
  const Problem smooth = shown.smoothed(0.5);
  EXPECT_EQ(smooth.evaluate(shown.start).objective,
            problem.smoothed(0.5).evaluate(problem.start).objective);
}

TEST(Permuted, KeepsEverythingButTheOrder) {
  for (const Problem& problem : random_problems()) {
    const Eigen::Index n = problem.dimension();
    EXPECT_EQ(permuted().applies(problem), n > 1);
    for (std::uint64_t seed = 0; n > 1 && seed < 5; ++seed) {
      const Problem shown = permuted().perturbed(problem, seed);
      const std::vector<Eigen::Index> place = places(problem, shown);
      ASSERT_LT(std::ranges::max(place), n);
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

/// Of each coordinate: -1 where it is reflected.
std::vector<double> signs(const Problem& problem, const Problem& shown) {
  std::vector<double> all;
  for (Eigen::Index i = 0; i < problem.dimension(); ++i) {
    all.push_back(shown.lower[i] == problem.lower[i] ? 1 : -1);
  }
  return all;
}

TEST(Reflected, KeepsEverythingButTheSigns) {
  for (const Problem& problem : random_problems()) {
    EXPECT_TRUE(reflected().applies(problem));
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const Problem shown = reflected().perturbed(problem, seed);
      const std::vector<double> all = signs(problem, shown);
      EXPECT_THAT(all, Contains(-1)) << "one at least";
      expect_same(problem, shown,
                  Eigen::Map<const Vector>(all.data(), problem.dimension()).asDiagonal());
      EXPECT_EQ(shown.variables[0].name, problem.variables[0].name);
    }
  }
}

/// How often what is read of the perturbed problem is drawn by as many seeds.
template <class Read>
auto draws_of(const Perturbation& perturbation, Eigen::Index dimension, int seeds,
              const Read& read) {
  Random random(1);
  const Problem problem = random_problem(random, {.dimension = dimension});
  std::map<decltype(read(problem, problem)), int> drawn;
  for (int seed = 0; seed < seeds; ++seed) {
    ++drawn[read(problem, perturbation.perturbed(problem, static_cast<std::uint64_t>(seed)))];
  }
  return drawn;
}

TEST(Permuted, DrawsEveryCycleAlike) {
  const auto drawn = draws_of(permuted(), 4, 6000, places);
  EXPECT_EQ(drawn.size(), 6U);  // (4 - 1)!
  for (const auto& [order, times] : drawn) EXPECT_NEAR(times, 1000, 5 * std::sqrt(1000 * 5 / 6.0));
}

TEST(Reflected, DrawsTheSignsAlike) {
  constexpr int size = 8000;
  const auto drawn = draws_of(reflected(), 3, size, signs);
  EXPECT_EQ(drawn.size(), 7U);
  // Of k reflections: as drawn (1/8, then one of the k is named), or as k - 1 of them and the last
  // one named: k / 3 (1/8 + 1/8).
  for (const auto& [turned, times] : drawn) {
    const double share = static_cast<double>(std::ranges::count(turned, -1)) / 12;
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
  for (const Problem& problem : random_problems()) {
    if (!rotated().applies(problem)) continue;
    const TrueValues own = true_values_at(problem, problem.start);
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const Problem shown = rotated().perturbed(problem, seed);
      const Vector& best = *problem.best_point;
      EXPECT_EQ(*shown.best_point, best);
      EXPECT_EQ(shown.true_values(best).objective, true_values_at(problem, best).objective);
      EXPECT_TRUE(shown.variables.empty());
      EXPECT_NEAR((shown.start - best).norm(), (problem.start - best).norm(), 1e-12);
      EXPECT_NEAR(shown.evaluate(shown.start).objective, problem.evaluate(problem.start).objective,
                  1e-11);
      EXPECT_NEAR(shown.true_values(shown.start).objective, own.objective, 1e-11);
      EXPECT_NEAR(shown.true_values(shown.start).violation, own.violation, 1e-11);
      EXPECT_NEAR(shown.differentiate(shown.start).gradient.norm(),
                  problem.differentiate(problem.start).gradient.norm(), 1e-10);
      EXPECT_TRUE(is_inside(shown, shown.start) && is_inside(shown, problem.lower));
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
      const Values up = shown.evaluate(x + step), down = shown.evaluate(x - step);
      const double scale = 1 + std::abs(d.gradient[i]);
      EXPECT_NEAR(d.gradient[i], (up.objective - down.objective) / 2e-5, 1e-6 * scale);
      const Vector slopes = (up.constraints - down.constraints) / 2e-5;
      EXPECT_LT((d.jacobian.col(i) - slopes).norm(), 1e-6);
    }
    EXPECT_LT((r.jacobian.transpose() * r.values - d.gradient).norm(),
              1e-11 * (1 + d.gradient.norm()));
    EXPECT_GT(expect_hessian_of_gradients(shown, x, 0.7, normal(problem.constraints, random)), 0);
    // At the best point: the same curvatures, but of other directions.
    const Vector none = Vector::Zero(problem.constraints);
    const Matrix own = problem.lagrangian_hessian(*problem.best_point, 1, none);
    const Matrix turned = shown.lagrangian_hessian(*problem.best_point, 1, none);
    const auto curvatures = [](const Matrix& m) {
      return m.selfadjointView<Eigen::Lower>().eigenvalues();
    };
    EXPECT_LT((curvatures(own) - curvatures(turned)).norm(), 1e-11 * own.norm());
    EXPECT_GT((own - turned).norm(), 1e-3 * own.norm());
  }
}

}  // namespace
}  // namespace ricochet
