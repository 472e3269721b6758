// What every perturbation promises.

#include "src/experiment/perturbations.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <set>

#include "ricochet/evaluator.h"
#include "src/core/evaluator.h"
#include "src/core/instance.h"
#include "tests/experiment/perturbations/random_problem.h"

namespace ricochet {
namespace {

/// The bits of everything that a solver is told at so many points of the box, in a row; where a
/// call throws, of the message.
std::vector<std::uint64_t> told(const Problem& problem, int points) {
  std::vector<std::uint64_t> bits;
  const auto add = [&bits](const auto& numbers) {
    for (const double number : numbers.reshaped()) {
      bits.push_back(std::isnan(number) ? 1 : std::bit_cast<std::uint64_t>(number));
    }
  };
  add(problem.start);
  add(problem.lower);
  for (int k = 0; k < points; ++k) {
    const double place = (k + 0.31) / points;
    const Vector x = problem.lower + place * (problem.upper - problem.lower);
    try {
      const Values values = problem.evaluate(x);
      bits.push_back(std::bit_cast<std::uint64_t>(values.objective));
      add(values.constraints);
      const Derivatives d = problem.differentiate(x);
      add(d.gradient);
      add(d.jacobian);
      if (problem.residuals) add(problem.residuals(x).values);
      add(problem.lagrangian_hessian(x, 1, Vector::Ones(problem.constraints)));
    } catch (const std::exception&) {
      bits.push_back(2);
    }
  }
  return bits;
}

bool moves_coordinates(const Perturbation& perturbation) {
  return perturbation.name == "permuted" || perturbation.name == "reflected" ||
         perturbation.name == "rotated";
}

class EveryPerturbation : public testing::TestWithParam<Perturbation> {
 protected:
  const Perturbation& perturbation() const { return GetParam(); }

  /// Random problems that it applies to, and instances of them, and formulations.
  std::vector<Problem> problems() const {
    const std::vector<Problem> stated = random_problems();
    std::vector<Problem> all;
    for (std::size_t k = 0; k < stated.size(); ++k) {
      const Problem& problem = stated[k];
      const Problem formulations[] = {problem, instance(problem, 3), problem.smoothed(0.2),
                                      penalised(problem, 2)};
      const Problem& shown =
          formulations[(k + k / 4) % 4];  // another one for every kind of constraints
      if (perturbation().applies(shown)) all.push_back(shown);
    }
    EXPECT_GE(all.size(), 8U);
    return all;
  }
};

TEST_P(EveryPerturbation, KeepsWhatIsAskedAndJudged) {
  Random random(3);
  for (const Problem& problem : problems()) {
    const Problem shown = perturbation().perturbed(problem, 11);
    EXPECT_EQ(shown.name, problem.name);
    EXPECT_EQ(shown.instance, problem.instance);
    EXPECT_EQ(shown.dimension(), problem.dimension());
    EXPECT_EQ(shown.constraints, problem.constraints);
    EXPECT_EQ(shown.equalities, problem.equalities);
    EXPECT_EQ(shown.best_known, problem.best_known);
    EXPECT_EQ(!shown.differentiate, !problem.differentiate);
    EXPECT_EQ(!shown.residuals, !problem.residuals);
    EXPECT_EQ(!shown.lagrangian_hessian, !problem.lagrangian_hessian);
    EXPECT_EQ(!shown.smoothed, !problem.smoothed);
    EXPECT_NEAR(true_values_at(shown, *shown.best_point).objective,
                true_values_at(problem, *problem.best_point).objective, 1e-12);
    EXPECT_NEAR(true_values_at(shown, *shown.best_point).violation,
                true_values_at(problem, *problem.best_point).violation, 1e-12);
    if (moves_coordinates(perturbation())) continue;
    EXPECT_EQ(shown.lower, problem.lower);
    EXPECT_EQ(shown.upper, problem.upper);
    EXPECT_EQ(*shown.best_point, *problem.best_point);
    for (int k = 0; k < 10; ++k) {
      const Vector x = uniform_point(problem, random);
      EXPECT_EQ(true_values_at(shown, x).objective, true_values_at(problem, x).objective);
      EXPECT_EQ(true_values_at(shown, x).violation, true_values_at(problem, x).violation);
    }
  }
}

TEST_P(EveryPerturbation, JudgesTheSameWhateverTheSolverWasTold) {
  Random random(3);
  for (const Problem& problem : problems()) {
    const Problem shown = perturbation().perturbed(problem, 11);
    const Problem undisturbed = perturbation().perturbed(problem, 11);
    Scorer scorer(shown);
    Evaluator evaluator(shown, {200}, &scorer);
    while (!evaluator.over()) {
      const Vector x = uniform_point(shown, random);
      evaluator.values(x);
      evaluator.derivatives(x);
    }
    for (const Improvement& step : scorer.trace()) {
      const TrueValues true_values = true_values_at(undisturbed, step.x);
      EXPECT_EQ(step.true_values.objective, true_values.objective);
      EXPECT_EQ(step.true_values.violation, true_values.violation);
    }
  }
}

TEST_P(EveryPerturbation, HasTheSameBitsForTheSameSeed) {
  for (const Problem& problem : problems()) {
    EXPECT_EQ(told(perturbation().perturbed(problem, 5), 10),
              told(perturbation().perturbed(problem, 5), 10));
  }
}

TEST_P(EveryPerturbation, HasAnotherDrawForAnotherSeedOrNone) {
  const std::set<std::string> without_chance = {
      "plain", "truncated", "slow", "infinite-where-infeasible", "quantised", "binary-constraints"};
  std::set<std::vector<std::uint64_t>> different;
  const Problem problem = problems().back();
  const int points = perturbation().name == "throwing" ? 1000 : 50;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    different.insert(told(perturbation().perturbed(problem, seed), points));
  }
  EXPECT_EQ(different.size() == 1, without_chance.contains(perturbation().name));
}

TEST_P(EveryPerturbation, IsSeenAtEverySmoothing) {
  int seen = 0;
  for (const Problem& problem : problems()) {
    if (!problem.smoothed) continue;
    const Problem shown = perturbation().perturbed(problem, 5);
    const Problem smooth = shown.smoothed(0.3);
    EXPECT_EQ(smooth.lower, shown.lower);
    EXPECT_EQ(smooth.upper, shown.upper);
    EXPECT_EQ(smooth.start, shown.start);
    EXPECT_EQ(smooth.start_scales, shown.start_scales);
    EXPECT_EQ(*smooth.best_point, *shown.best_point);
    EXPECT_EQ(smooth.true_values(shown.start).objective,
              true_values_at(shown, shown.start).objective);
    // What it does to a smoothing parameter is what it does to the problem at that smoothing
    // parameter.
    EXPECT_EQ(told(perturbation().perturbed(problem, 5).smoothed(0.3), 10),
              told(perturbation().perturbed(problem.smoothed(0.3), 5), 10));
    const int points = perturbation().name == "throwing" ? 1000 : 20;
    seen += told(smooth, points) != told(problem.smoothed(0.3), points);
  }
  EXPECT_EQ(seen == 0, perturbation().name == "plain" || perturbation().name == "slow");
}

TEST_P(EveryPerturbation, SaysWhatItIs) {
  EXPECT_FALSE(perturbation().name.empty());
  EXPECT_FALSE(perturbation().summary.empty());
}

std::string name_of(const testing::TestParamInfo<Perturbation>& tested) {
  std::string name;
  for (const char c : tested.param.name) {
    if (c != '-') name += c;
  }
  return name;
}

TEST(Perturbations, TellApartHowARunShowsItsProblem) {
  EXPECT_EQ(shown_as("count", "plain"), "count");
  EXPECT_EQ(shown_as("count", "noisy"), "count/noisy");
}

INSTANTIATE_TEST_SUITE_P(Of, EveryPerturbation, testing::ValuesIn(all_perturbations()), name_of);

TEST(Perturbations, HaveNamesOfTheirOwnPlainFirst) {
  std::set<std::string> names;
  for (const Perturbation& perturbation : all_perturbations()) names.insert(perturbation.name);
  EXPECT_EQ(names.size(), all_perturbations().size());
  EXPECT_EQ(all_perturbations().front().name, "plain");
}

}  // namespace
}  // namespace ricochet
