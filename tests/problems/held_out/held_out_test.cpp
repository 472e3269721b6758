#include "problems/held_out/held_out.h"

#include "tests/problems/classic/claims.h"

namespace ricochet::held_out {
namespace {

const std::vector<Problem>& problems() {
  static const std::vector<Problem> all = every_problem(families());
  return all;
}

TEST(HeldOut, IsChosenByItsNameAlone) {
  ASSERT_EQ(families().size(), 5U);
  for (const Family& family : families()) EXPECT_GE(family.problems.size(), 12U) << family.name;
  for (const Problem& problem : problems()) {
    EXPECT_FALSE(is_chosen(problem, {"*"})) << problem.name;
    EXPECT_FALSE(is_chosen(problem, {"*-*"})) << problem.name;
    EXPECT_TRUE(is_chosen(problem, {"outside-*"})) << problem.name;
    EXPECT_FALSE(problem.source.empty() || problem.provenance.empty()) << problem.name;
  }
}

TEST(HeldOut, HasItsBestValueAtItsBestPoint) {
  for (const Problem& problem : problems()) {
    SCOPED_TRACE(problem.name);
    const Vector& best = problem.best_point.value();
    ASSERT_EQ(best.size(), problem.dimension());
    EXPECT_EQ(best.cwiseMax(problem.lower).cwiseMin(problem.upper), best);
    EXPECT_EQ(problem.start.cwiseMax(problem.lower).cwiseMin(problem.upper), problem.start);
    const TrueValues at_best = true_values_at(problem, best);
    EXPECT_EQ(at_best.violation, 0);
    // What is certified has eleven digits; a best point is published with eight.
    const double size = std::max(1.0, std::abs(*problem.best_known));
    const double digits = problem.differentiate ? 1e-10 : 1e-6;
    EXPECT_NEAR(at_best.objective, *problem.best_known, digits * size);
    EXPECT_LE(problem.tolerance, 1e-4 * size) << "nearly everything would have solved it";
    const TrueValues at_start = true_values_at(problem, problem.start);
    EXPECT_TRUE(at_start.violation > 0 ||
                at_start.objective > *problem.best_known + problem.tolerance);
  }
}

TEST(HeldOut, HasNoBetterPointInTheBoxOrNearTheBest) {
  for (const Problem& problem : problems()) {
    SCOPED_TRACE(problem.name);
    Random random(seed_of(problem.name, "points", 0, 0));
    for (int k = 0; k < 2000; ++k) {
      const Vector far = uniform_point(problem, random);
      const double near = std::pow(10, -1.0 * (k % 6));
      const TrueValues found =
          true_values_at(problem, near * far + (1 - near) * *problem.best_point);
      if (found.violation > 0) continue;
      ASSERT_GE(found.objective, *problem.best_known - problem.tolerance);
    }
  }
}

TEST(HeldOut, HasTheDerivativesOfDifferences) {
  int with_derivatives = 0;
  for (const Problem& problem : problems()) {
    SCOPED_TRACE(problem.name);
    ASSERT_EQ(!problem.differentiate, problem.name.starts_with("outside-rough-"));
    ASSERT_EQ(!problem.residuals, !problem.name.starts_with("outside-fit-"));
    if (!problem.differentiate) continue;
    ++with_derivatives;
    Random random(seed_of(problem.name, "derivatives", 0, 0));
    const Vector x = classic::point_near_best(problem, random);
    const Derivatives d = problem.differentiate(x);
    const auto values = [&](const Vector& y) { return classic::all_of(problem.evaluate(y)); };
    EXPECT_EQ(classic::all_of(d.values), values(x));
    Matrix both(1 + problem.constraints, problem.dimension());
    both << d.gradient.transpose(), d.jacobian;
    classic::expect_columns(problem, x, both, values, 1e-5);
    if (!problem.residuals) continue;
    const Residuals r = problem.residuals(x);
    EXPECT_EQ(d.values.objective, r.values.squaredNorm() / 2);
    classic::expect_columns(
        problem, x, r.jacobian, [&](const Vector& y) { return problem.residuals(y).values; }, 1e-5);
  }
  EXPECT_EQ(with_derivatives, 54);
}

TEST(HeldOut, PenalisesSoThatTheBestStaysBest) {
  for (const Problem& problem : problems()) {
    if (problem.constraints == 0) continue;
    SCOPED_TRACE(problem.name);
    const auto multipliers = classic::multipliers_at_best(problem);
    ASSERT_TRUE(multipliers);
    EXPECT_GE(problem.penalty_weight, multipliers->lpNorm<Eigen::Infinity>());
  }
}

// Orders go up to whole levels, so all of them can be tried.
TEST(HeldOut, HasTheBestOfAllInventories) {
  const Problem inventory = classic::named(problems(), "outside-rough-inventory");
  double best = infinity;
  for (int reorder = 0; reorder <= 150; ++reorder) {
    for (int up_to = reorder; up_to <= 300; ++up_to) {
      const Vector x{{static_cast<double>(reorder), static_cast<double>(up_to)}};
      best = std::min(best, inventory.evaluate(x).objective);
    }
  }
  EXPECT_DOUBLE_EQ(best, *inventory.best_known);
}

}  // namespace
}  // namespace ricochet::held_out
