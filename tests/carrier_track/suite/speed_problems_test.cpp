#include "problems/carrier_track/suite/speed_problems.h"

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/best_known.h"
#include "problems/carrier_track/suite/problem_from_function.h"
#include "ricochet/run.h"
#include "src/core/instance.h"
#include "tests/carrier_track/gradients/differences.h"
#include "tests/core/hessian_check.h"
#include "tests/support/problems.h"
#include "tests/support/refusals.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {
namespace {

Vector at(double omega) {
  return Vector::Constant(1, omega);
}

/// C1, of which counts up to a limit shall be quiet.
Problem limited_top_speed(double limit) {
  Machine c1 = exploratory_machine("C1");
  c1.quiet_limit = limit;
  return top_speed_problem(c1);
}

/// Where the count, 7 at 15 rad/s, leaves the limit because an impact gets faster, a sharp
/// surrogate passes its level, whether the limit is a whole number or not.
TEST(TopSpeed, HasASurrogateThatPassesItsLevelWhereTheCountLeavesTheLimit) {
  for (const double limit : {6.0, 6.5}) {
    const Problem count = limited_top_speed(limit);
    EXPECT_EQ(count.evaluate(at(9.0)).objective, -9.0);
    EXPECT_EQ(count.evaluate(at(15.0)).constraints[0], 1.0);
    const Problem sharp = count.formulated({1e-5});
    int crossings = 0;
    for (double omega = 9; omega < 15; omega += 0.01) {
      const bool quiet = count.evaluate(at(omega)).constraints[0] <= 0;
      const double shown = sharp.evaluate(at(omega)).constraints[0];
      // Off the level, it is on the same side as the count.
      EXPECT_TRUE(std::abs(shown) <= 0.01 || (shown < 0) == quiet) << omega;
      crossings += quiet != (count.evaluate(at(omega + 0.01)).constraints[0] <= 0);
    }
    EXPECT_GT(crossings, 0);
  }
}

/// Of every family, those of up to eight variables.
std::vector<Problem> small_problems() {
  std::vector<Problem> small;
  for (const Family& family : families_of({exploratory_machine("C1")})) {
    std::ranges::copy_if(family.problems, std::back_inserter(small),
                         [](const Problem& problem) { return problem.dimension() <= 8; });
  }
  return small;
}

TEST(ProblemFromFunction, HasTheDerivativesOfItsValuesAndIsJudgedByTheTrueOnes) {
  const auto sum = [](const Values& values) { return values.objective + values.constraints.sum(); };
  int compared = 0, violated = 0;
  for (const Problem& exact : small_problems()) {
    Random random(7);
    const bool one = exact.dimension() == 1;
    const Vector x = one ? at(4.321) : uniform_point(exact, random);
    const Problem smooth = exact.differentiate ? exact : exact.formulated({0.25});
    expect_derivatives_of_values(smooth, x, one ? 1e-7 : 1e-8, one ? 1e-6 : 1e-4);
    ++compared;
    if (exact.differentiate) continue;
    const Problem sharper = smooth.smoothed(0.1);
    EXPECT_EQ(sharper.name, exact.name);
    EXPECT_EQ(sum(sharper.evaluate(x)), sum(exact.formulated({0.1}).evaluate(x))) << exact.name;
    EXPECT_NE(sum(smooth.evaluate(x)), sum(exact.evaluate(x))) << exact.name;
    EXPECT_NE(sum(smooth.evaluate(x)), sum(sharper.evaluate(x))) << exact.name;
    for (const Vector& point : {x, Vector(exact.lower + 0.9 * (exact.upper - exact.lower))}) {
      const auto values = true_values_of(exact.evaluate(point));
      violated += values.violation > 0 ? 1 : 0;
      for (const Problem& shown : {smooth, sharper}) {
        EXPECT_EQ(shown.true_values(point).objective, values.objective) << exact.name;
        EXPECT_EQ(shown.true_values(point).violation, values.violation) << exact.name;
      }
    }
  }
  EXPECT_EQ(compared, 12);
  EXPECT_GE(violated, 5) << "top speed, design and three risks";
}

TEST(ProblemFromFunction, HasTheSecondDerivativesOfItsGradientInEveryInstance) {
  Random random(1);
  int curved = 0;
  for (const Problem& problem : small_problems()) {
    for (const Formulation& formulation : problem.formulations()) {
      const Problem formulated = problem.formulated(formulation);
      const auto has_second = static_cast<bool>(formulated.lagrangian_hessian);
      EXPECT_EQ(has_second, static_cast<bool>(formulated.differentiate)) << problem.name;
      curved += has_second;
    }
    const Problem formulated = problem.formulated({problem.differentiate ? 0 : problem.smoothing});
    int compared = 0;
    for (int number = 0; number < 6; ++number) {
      const Problem moved = instance(formulated, number);
      const Vector multipliers = normal(moved.constraints, random);
      compared += expect_hessian_of_gradients(moved, uniform_point(moved, random), uniform(random),
                                              multipliers, 1e-5, 1e-4);
    }
    EXPECT_GT(compared, 2) << problem.name;
  }
  EXPECT_GE(curved, 8);
}

TEST(ScannedBest, IsTheFirstOfTheLowest) {
  const BestKnown best = scan_for_best(falling_stairs(), 0.001);
  EXPECT_EQ(best.value, -3);
  EXPECT_EQ(best.point[0], 2.0);
  EXPECT_THAT(best.provenance, HasSubstr("0.001"));
}

TEST(ScannedBest, IsBisectedToTheEdgeOfWhatIsFeasible) {
  Problem problem = two_stretches();
  const BestKnown best = scan_for_best(problem, 0.01);
  EXPECT_LE(best.point[0], 3.14159265);
  EXPECT_NEAR(best.point[0], 3.14159265, 1e-7);
  EXPECT_EQ(best.value, -best.point[0]);
  // The last stretch lies between two places of the scan, two steps beyond the end of the first.
  problem.evaluate = [](const Vector& x) {
    const bool feasible = x[0] <= 2.2121 || (x[0] > 2.2315 && x[0] <= 2.2325);
    return Values{-x[0], Vector::Constant(1, feasible ? 0.0 : 1.0)};
  };
  EXPECT_NEAR(scan_for_best(problem, 0.01).point[0], 2.2325, 1e-7);
}

TEST(ScannedBest, IsInfiniteWhereNothingIsFeasible) {
  const Problem problem = limited(-1);
  const BestKnown best = scan_for_best(problem, 0.01);
  EXPECT_EQ(best.value, infinity);
  EXPECT_EQ(best.point.size(), 0);
  EXPECT_TRUE(scanned_best(problem).empty());
  EXPECT_THROW(scanned_best(sphere(2, 0)), std::invalid_argument) << "two variables";
}

/// To a step for a top speed; counts are whole numbers.
TEST(ScannedBest, IsThatOfALoopOverAllSpeedsInEveryFormulation) {
  for (const auto ask : {count_problem, top_speed_problem}) {
    Problem problem = ask(exploratory_machine("C4"));
    problem.scan_step = 0.01;
    problem = with_scanned_best(problem, scanned_best(problem));
    double least = infinity;
    for (int k = 1; k <= 1800; ++k) {
      const TrueValues values = true_values_at(problem, at(k * 0.01));
      if (values.violation == 0) least = std::min(least, values.objective);
    }
    EXPECT_LE(*problem.best_known, least);
    EXPECT_GT(*problem.best_known, least - 0.01);
    EXPECT_EQ(true_values_at(problem, *problem.best_point).objective, problem.best_known);
    EXPECT_EQ(problem.provenance, "exhaustive scan, step 0.01, then bisection");
    for (const double smoothing : {0.25, 0.1}) {
      const Problem shown = problem.formulated({smoothing});
      EXPECT_EQ(shown.best_known, problem.best_known);
      EXPECT_EQ(shown.smoothed(0.3).best_known, problem.best_known);
    }
  }
}

TEST(BestKnown, IsReadAsItWasWritten) {
  const BestValues values{"0123456789abcdef",
                          {{"count-C1", {3.0, Vector::Constant(1, 0.1), "a scan"}},
                           {"design-C2", {-1.0 / 3, Vector::LinSpaced(5, 0, 1e-7), "a solver"}},
                           {"robust-C3", {infinity, Vector(), "none"}}}};
  const BestValues read = parse_best_values(write_best_values(values), "text");
  EXPECT_EQ(read.machine, values.machine);
  ASSERT_EQ(read.of.size(), values.of.size());
  for (const auto& [name, best] : values.of)
    EXPECT_THAT(read.of.at(name), FieldsAre(best.value, best.point, best.provenance)) << name;
}

TEST(BestKnown, RefusesWhatIsNoSuchTextOrOfAnotherVersionOfTheSuite) {
  const auto parse = [](const std::string& text) {
    return parse_best_values(text, "best_known.toml");
  };
  const std::string version = fmt::format("suite = {}\n", suite_version);
  EXPECT_NO_THROW(parse(version + "machine = \"m\""));
  for (const char* text :
       {"", "machine = 3", "machine = \"m\"\ncount-C1 = 3",
        "machine = \"m\"\n[count-C1]\nvalue = 1",
        "machine = \"m\"\n[count-C1]\nvalue = 1\nprovenance = \"p\"\npoint = [\"x\"]"}) {
    EXPECT_THROW(parse(version + text), InputError) << text;
  }
  expect_refusals(parse,
                  {{"interpretation = \"r\"", "best_known.toml: best values of version 1"},
                   {"suite = 1\nmachine = \"m\"", "best_known.toml: best values of version 1"}});
}

TEST(BestKnown, IsToldToTheProblemsOfItsMachineAlone) {
  EXPECT_EQ(best_values().machine, default_machine_hash());
  const auto& [name, best] = *best_values().of.begin();
  Problem of_this, of_other;
  of_this.name = of_other.name = name;
  know_best(of_this, best_values().machine);
  EXPECT_EQ(std::tie(*of_this.best_known, *of_this.best_point, of_this.provenance),
            std::tie(best.value, best.point, best.provenance));
  for (const char* other : {"", "0123456789abcdef"}) {
    know_best(of_other, other);
    EXPECT_FALSE(of_other.best_known);
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
