#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "problems/carrier_track/suite/best_known.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/run.h"
#include "tests/support/scenes.h"
#include "tests/studies/best_values/some_problems.h"

namespace ricochet::carrier_track {
namespace {

using studies::best_values::cut_bowl;
using studies::best_values::speeds;
using studies::best_values::stairs;

constexpr double step = 0.01;

/// A problem of C4, to be scanned by that step.
Problem scanned(const Problem& problem) {
  return with_scanned_best(problem, scanned_best(problem));
}

Problem of_c4(Problem (*ask)(const Machine&)) {
  Problem problem = ask(machine_of(find_case("C4"), exploratory_scene()));
  problem.scan_step = step;
  return problem;
}

TEST(ScannedBest, IsTheFirstOfTheLowest) {
  const BestKnown best = scan_for_best(stairs(), 0.001);
  EXPECT_EQ(best.value, -3);
  EXPECT_EQ(best.point[0], 2.0);
  EXPECT_NE(best.provenance.find("0.001"), std::string::npos);
}

TEST(ScannedBest, IsBisectedToTheEdgeOfWhatIsFeasible) {
  const BestKnown best = scan_for_best(speeds(), 0.01);
  EXPECT_LE(best.point[0], 3.14159265);
  EXPECT_NEAR(best.point[0], 3.14159265, 1e-7);
  EXPECT_EQ(best.value, -best.point[0]);
}

TEST(ScannedBest, LooksAStepApartFromWhereBisectionEnds) {
  Problem problem = speeds();
  // The last stretch lies between two places of the scan, two steps beyond the end of the first.
  problem.evaluate = [](const Vector& x) {
    const bool feasible = x[0] <= 2.2121 || (x[0] > 2.2315 && x[0] <= 2.2325);
    return Values{-x[0], Vector::Constant(1, feasible ? 0.0 : 1.0)};
  };
  EXPECT_NEAR(scan_for_best(problem, 0.01).point[0], 2.2325, 1e-7);
}

TEST(ScannedBest, IsInfiniteWhereNothingIsFeasible) {
  Problem problem = speeds();
  problem.evaluate = [](const Vector& x) { return Values{-x[0], Vector::Constant(1, 1.0)}; };
  const BestKnown best = scan_for_best(problem, 0.01);
  EXPECT_TRUE(std::isinf(best.value));
  EXPECT_EQ(best.point.size(), 0);
  EXPECT_TRUE(scanned_best({problem}).empty());
}

TEST(ScannedBest, OfACountIsThatOfALoopOverAllSpeeds) {
  const Problem problem = scanned(of_c4(count_problem));
  double least = 1e9;
  for (int k = 1; k <= 1800; ++k) {
    least = std::min(least, problem.evaluate(Vector::Constant(1, k * step)).objective);
  }
  EXPECT_EQ(problem.best_known, least);
  EXPECT_EQ(true_values_at(problem, *problem.best_point).objective, least);
  EXPECT_EQ(problem.provenance, "exhaustive scan, step 0.01, then bisection");
}

TEST(ScannedBest, OfATopSpeedIsWithinAStepOfThatOfALoop) {
  const Problem problem = scanned(of_c4(top_speed_problem));
  double fastest = 0;
  for (int k = 1; k <= 1800; ++k) {
    const TrueValues true_values = true_values_at(problem, Vector::Constant(1, k * step));
    if (true_values.violation == 0) fastest = k * step;
  }
  ASSERT_GT(fastest, 0);
  EXPECT_LE(*problem.best_known, -fastest);
  EXPECT_GT(*problem.best_known, -fastest - step);
}

TEST(ScannedBest, IsKnownInEveryFormulation) {
  const Problem problem = scanned(of_c4(count_problem));
  for (const double smoothing : {0.25, 0.1}) {
    const Problem shown = problem.formulated({smoothing});
    EXPECT_EQ(shown.best_known, problem.best_known);
    EXPECT_EQ(shown.smoothed(0.3).best_known, problem.best_known);
  }
}

TEST(ScannedBest, IsOfOneVariable) {
  EXPECT_THROW(scanned_best({cut_bowl()}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet::carrier_track
