// What every perturbation promises, and what perturbations are made of.

#include "src/experiment/perturbations.h"

#include "ricochet/evaluator.h"
#include "src/core/evaluator.h"
#include "tests/experiment/perturbations/random_problem.h"
#include "tests/support/problems.h"

namespace ricochet {
namespace {

/// The bits of everything that a solver is told at so many points of the box, in a row; where a
/// call throws, 2.
std::vector<std::uint64_t> bits_told(const Problem& problem, int points) {
  std::vector<std::uint64_t> bits;
  const auto add = [&bits](const auto& numbers) {
    for (const double number : numbers) {
      bits.push_back(std::isnan(number) ? 1 : std::bit_cast<std::uint64_t>(number));
    }
  };
  add(problem.start);
  add(problem.lower);
  for (int k = 0; k < points; ++k) {
    const double place = (k + 0.31) / points;
    const Vector x = problem.lower + place * (problem.upper - problem.lower);
    try {
      const Values alone = problem.evaluate(x);
      add(std::vector{alone.objective});
      add(alone.constraints);
      add(told_at(problem, x).numbers());
    } catch (const std::exception&) {
      bits.push_back(2);
    }
  }
  return bits;
}

class EveryPerturbation : public testing::TestWithParam<Perturbation> {
 protected:
  const std::function<Problem(const Problem&, std::uint64_t)> perturbed = GetParam().perturbed;

  bool is_one_of(const std::set<std::string>& names) const {
    return names.contains(GetParam().name);
  }

  /// Random problems that it applies to, and instances of them, and formulations.
  std::vector<Problem> problems() const {
    const std::vector<Problem> stated = random_problems();
    std::vector<Problem> all;
    for (std::size_t k = 0; k < stated.size(); ++k) {
      const Problem& problem = stated[k];
      const Problem formulations[] = {problem, instance(problem, 3), problem.smoothed(0.2),
                                      penalised(problem, 2)};
      // Another one for every kind of constraints.
      const Problem& shown = formulations[(k + k / 4) % 4];
      if (GetParam().applies(shown)) all.push_back(shown);
    }
    EXPECT_GE(all.size(), 8U);
    return all;
  }
};

auto what_is_asked(const Problem& p) {
  return std::tuple(p.name, p.instance, p.dimension(), p.constraints, p.equalities, p.best_known,
                    !p.differentiate, !p.residuals, !p.lagrangian_hessian, !p.smoothed);
}

auto box_and_best_of(const Problem& p) {
  return std::tuple(p.lower, p.upper, *p.best_point);
}

TEST_P(EveryPerturbation, KeepsWhatIsAskedAndJudged) {
  Random random(3);
  for (const Problem& problem : problems()) {
    const Problem shown = perturbed(problem, 11);
    EXPECT_EQ(what_is_asked(shown), what_is_asked(problem));
    const TrueValues best = true_values_at(shown, *shown.best_point);
    const TrueValues own = true_values_at(problem, *problem.best_point);
    EXPECT_NEAR(best.objective, own.objective, 1e-12);
    EXPECT_NEAR(best.violation, own.violation, 1e-12);
    if (is_one_of({"permuted", "reflected", "rotated"})) continue;
    EXPECT_EQ(box_and_best_of(shown), box_and_best_of(problem));
    for (int k = 0; k < 10; ++k) {
      const Vector x = uniform_point(problem, random);
      EXPECT_EQ(true_values_at(shown, x), true_values_at(problem, x));
    }
  }
}

TEST_P(EveryPerturbation, JudgesTheSameWhateverTheSolverWasTold) {
  Random random(3);
  for (const Problem& problem : problems()) {
    const Problem shown = perturbed(problem, 11);
    const Problem undisturbed = perturbed(problem, 11);
    Scorer scorer(shown);
    Evaluator evaluator(shown, {200}, &scorer);
    while (!evaluator.over()) {
      const Vector x = uniform_point(shown, random);
      evaluator.values(x);
      evaluator.derivatives(x);
    }
    for (const Improvement& step : scorer.trace()) {
      EXPECT_EQ(step.true_values, true_values_at(undisturbed, step.x));
    }
  }
}

TEST_P(EveryPerturbation, HasTheSameBitsForTheSameSeedAndOthersForAnotherOrNone) {
  for (const Problem& problem : problems()) {
    EXPECT_EQ(bits_told(perturbed(problem, 5), 10), bits_told(perturbed(problem, 5), 10));
  }
  std::set<std::vector<std::uint64_t>> different;
  const Problem problem = problems().back();
  const int points = is_one_of({"throwing"}) ? 1000 : 50;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    different.insert(bits_told(perturbed(problem, seed), points));
  }
  EXPECT_EQ(different.size() == 1, is_one_of({"plain", "truncated", "slow", "quantised",
                                              "infinite-where-infeasible", "binary-constraints"}));
}

TEST_P(EveryPerturbation, IsSeenAtEverySmoothing) {
  int seen = 0;
  for (const Problem& problem : problems()) {
    if (!problem.smoothed) continue;
    const Problem shown = perturbed(problem, 5);
    const Problem smooth = shown.smoothed(0.3);
    EXPECT_EQ(box_and_best_of(smooth), box_and_best_of(shown));
    EXPECT_EQ(smooth.start, shown.start);
    EXPECT_EQ(smooth.start_scales, shown.start_scales);
    EXPECT_EQ(smooth.true_values(shown.start).objective,
              true_values_at(shown, shown.start).objective);
    // It does the same to the problem at that smoothing parameter.
    EXPECT_EQ(bits_told(perturbed(problem, 5).smoothed(0.3), 10),
              bits_told(perturbed(problem.smoothed(0.3), 5), 10));
    const int points = is_one_of({"throwing"}) ? 1000 : 20;
    seen += bits_told(smooth, points) != bits_told(problem.smoothed(0.3), points);
  }
  EXPECT_EQ(seen == 0, is_one_of({"plain", "slow"}));
}

INSTANTIATE_TEST_SUITE_P(Of, EveryPerturbation, testing::ValuesIn(all_perturbations()),
                         [](const auto& tested) { return test_name(tested.param.name); });

TEST(Perturbations, HaveNamesOfTheirOwnPlainFirst) {
  std::set<std::string> names;
  for (const Perturbation& each : all_perturbations()) {
    EXPECT_FALSE(each.name.empty());
    EXPECT_FALSE(each.summary.empty());
    names.insert(each.name);
  }
  EXPECT_EQ(names.size(), all_perturbations().size());
  EXPECT_EQ(all_perturbations().front().name, "plain");
  EXPECT_EQ(shown_as("count", "plain"), "count");
  EXPECT_EQ(shown_as("count", "noisy"), "count/noisy");
}

/// Adds 1 to whatever the objective is.
class OneMore : public PerturbedCalls {
 public:
  Values values(const Problem& shown, const Vector& x) override {
    Values told = shown.evaluate(x);
    told.objective += 1;
    return told;
  }
};

Problem with_one_more(const Problem& problem) {
  return perturbed_by(std::make_shared<OneMore>(), problem);
}

TEST(PerturbedCalls, PassesOnWhatItDoesNothingAbout) {
  for (const Problem& problem : random_problems()) {
    const Problem same = with_one_more(problem);
    const Vector& x = problem.start;
    EXPECT_EQ(same.evaluate(x).objective, problem.evaluate(x).objective + 1);
    EXPECT_EQ(same.evaluate(x).constraints, problem.evaluate(x).constraints);
    const Vector multipliers = Vector::Ones(problem.constraints);
    EXPECT_EQ(told_at(same, x, 2, multipliers), told_at(problem, x, 2, multipliers));
    EXPECT_EQ(same.true_values(x).objective, true_values_at(problem, x).objective);
    EXPECT_EQ(same.smoothed(0.5).evaluate(x).objective,
              problem.smoothed(0.5).evaluate(x).objective + 1);
  }
}

TEST(PerturbedCalls, HasNoFunctionsThatTheProblemHasNot) {
  const Problem same =
      with_one_more(box_problem("bare", 1, 0, 1, 0, [](const Vector&) { return 0.0; }));
  EXPECT_FALSE(same.differentiate || same.residuals || same.lagrangian_hessian || same.smoothed);
}

TEST(PerturbedCalls, ComputesNothingTwiceWhereWhatIsShownIsTheTrueValues) {
  Random random(1);
  Problem problem = random_problem(random, {});
  int calls = 0;
  const auto counted = [&calls](const auto& function) {
    return [&calls, function](const Vector& x) { return ++calls, function(x); };
  };
  problem.evaluate = counted(problem.evaluate);
  problem.differentiate = counted(problem.differentiate);
  const Problem shown = with_one_more(problem);
  Scorer scorer(shown);
  Evaluator evaluator(shown, {1000}, &scorer);
  for (int k = 0; k < 10; ++k) evaluator.values(uniform_point(problem, random));
  EXPECT_EQ(calls, 10);
  evaluator.derivatives(uniform_point(problem, random));
  EXPECT_EQ(calls, 11);
  evaluator.residuals(uniform_point(problem, random));
  EXPECT_EQ(calls, 12) << "for the scorer, which has not been told the values";
}

/// The problem with everything that it tells replaced by what is drawn.
Problem drawn(Drawn by, const Problem& problem) {
  const auto draw = [](Eigen::Ref<Vector> values, Eigen::Ref<Matrix> slopes, Draws& draws) {
    for (double& value : values) value = draws.uniform();
    for (double& slope : slopes.reshaped()) slope = draws.uniform();
  };
  return told_by(draw, by, 3, problem);
}

void expect_all_different(const Told& one, const Told& other) {
  std::vector<double> all = one.numbers();
  for (const double number : other.numbers()) all.push_back(number);
  EXPECT_EQ(std::set<double>(all.begin(), all.end()).size(), all.size());
}

TEST(Telling, DrawsForEveryNumberByItself) {
  for (const Problem& problem : random_problems()) {
    for (const Drawn by : {Drawn::by_call, Drawn::by_point}) {
      const Problem told = drawn(by, problem);
      const Told here = told_at(told, problem.start);
      expect_all_different(here, told_at(told, *problem.best_point));
      EXPECT_EQ(here.hessian, here.hessian.transpose());
    }
  }
}

TEST(Telling, RepeatsAtAPointOrNever) {
  for (const Problem& problem : random_problems()) {
    const Vector& x = problem.start;
    const Problem by_point = drawn(Drawn::by_point, problem);
    EXPECT_EQ(told_at(by_point, x), told_at(by_point, x));
    EXPECT_EQ(by_point.evaluate(x), by_point.differentiate(x).values) << "derivatives or none";
    const Problem by_call = drawn(Drawn::by_call, problem);
    const Told first = told_at(by_call, x);
    EXPECT_EQ(told_at(drawn(Drawn::by_call, problem), x), first);
    expect_all_different(first, told_at(by_call, x));
  }
}

TEST(Telling, CountsTheCallsOfEverySmoothingTogether) {
  const Problem problem = random_problems().front();
  const Problem told = drawn(Drawn::by_call, problem);
  std::set<double> all;
  for (const Problem& next : {told, told.smoothed(0.1), told})
    all.insert(next.evaluate(next.start).objective);
  EXPECT_EQ(all.size(), 3U);
}

}  // namespace
}  // namespace ricochet
