#include "problems/carrier_track/questions/scanned_best.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "problems/carrier_track/questions/count.h"
#include "problems/carrier_track/questions/top_speed.h"
#include "src/core/verdict.h"
#include "tests/carrier_track/questions/exploratory_scene.h"
#include "tests/studies/best_values/some_questions.h"

namespace ricochet::carrier_track {
namespace {

using studies::best_values::cut_bowl;
using studies::best_values::speeds;
using studies::best_values::stairs;

constexpr double step = 0.01;

/// A question of C4, to be scanned by that step.
Question of_c4(Question (*ask)(const Machine&)) {
  Question question = ask(machine_of(find_case("C4"), exploratory_scene()));
  question.scan_step = step;
  return question;
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
  EXPECT_FALSE(with_scanned_best({problem}).stated.best_known);
}

TEST(ScannedBest, OfACountIsThatOfALoopOverAllSpeeds) {
  const Question question = with_scanned_best(of_c4(count_question));
  double least = 1e9;
  for (int k = 1; k <= 1800; ++k) {
    least = std::min(least, question.stated.evaluate(Vector::Constant(1, k * step)).objective);
  }
  EXPECT_EQ(question.stated.best_known, least);
  EXPECT_EQ(truth_at(question.stated, *question.stated.best_point).objective, least);
  EXPECT_EQ(question.stated.provenance, "exhaustive scan, step 0.01, then bisection");
}

TEST(ScannedBest, OfATopSpeedIsWithinAStepOfThatOfALoop) {
  const Question question = with_scanned_best(of_c4(top_speed_question));
  double fastest = 0;
  for (int k = 1; k <= 1800; ++k) {
    const Truth truth = truth_at(question.stated, Vector::Constant(1, k * step));
    if (truth.violation == 0) fastest = k * step;
  }
  ASSERT_GT(fastest, 0);
  EXPECT_LE(*question.stated.best_known, -fastest);
  EXPECT_GT(*question.stated.best_known, -fastest - step);
}

TEST(ScannedBest, IsKnownInEveryForm) {
  const Question question = with_scanned_best(of_c4(count_question));
  for (const double width : {0.25, 0.1}) {
    const Problem shown = question.problem({width});
    EXPECT_EQ(shown.best_known, question.stated.best_known);
    EXPECT_EQ(shown.smoothed(0.3).best_known, question.stated.best_known);
  }
}

TEST(ScannedBest, IsOfOneVariable) {
  EXPECT_THROW(with_scanned_best({cut_bowl()}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet::carrier_track
