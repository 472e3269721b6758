#include "tests/carrier_track/check/reference_integrators/accuracy.h"

#include <gtest/gtest.h>

namespace ricochet::carrier_track {
namespace {

/// A window of 8 s with limit 1 m/s; with 4 fast impacts partners are within 1 s.
Scene scene() {
  Scene result;
  result.window = Seconds{8.0};
  result.counting_limit = 1.0;
  return result;
}

Outcome outcome_of(std::vector<Impact> impacts, double end_position) {
  Outcome outcome;
  outcome.impacts = std::move(impacts);
  outcome.end = {8.0, end_position, 0.0};
  outcome.finished = true;
  return outcome;
}

Outcome true_values() {
  return outcome_of({{1.0, Wall::lower, 3.0},
                     {3.0, Wall::upper, 3.0},
                     {5.0, Wall::lower, 3.0},
                     {5.1, Wall::lower, 0.2},
                     {7.0, Wall::upper, 1.1}},
                    0.25);
}

TEST(Accuracy, OfARunWithItselfIsPerfect) {
  const Accuracy accuracy = compare(scene(), true_values(), true_values());
  EXPECT_EQ(accuracy.missed, 0);
  EXPECT_EQ(accuracy.spurious, 0);
  EXPECT_EQ(accuracy.matched, 4);
  EXPECT_EQ(accuracy.impact_time_error, 0.0);
  EXPECT_EQ(accuracy.count_difference, 0);
  EXPECT_EQ(accuracy.end_position_error, 0.0);
}

TEST(Accuracy, TakesTheLargestTimeErrorOfAllPairs) {
  Outcome outcome = true_values();
  outcome.impacts[0].time += 0.125;
  outcome.impacts[2].time -= 0.5;
  outcome.end.position = -0.25;
  const Accuracy accuracy = compare(scene(), outcome, true_values());
  EXPECT_EQ(accuracy.matched, 4);
  EXPECT_EQ(accuracy.impact_time_error, 0.5);
  EXPECT_EQ(accuracy.end_position_error, 0.5);
}

TEST(Accuracy, CountsMissedAndSpuriousAndStopsTheTimesThere) {
  Outcome outcome = true_values();
  outcome.impacts[1].wall = Wall::lower;  // spurious, and the upper one is missed
  outcome.impacts[2].time += 0.75;        // a pair, but after the paths have parted
  const Accuracy accuracy = compare(scene(), outcome, true_values());
  EXPECT_EQ(accuracy.missed, 1);
  EXPECT_EQ(accuracy.spurious, 1);
  EXPECT_EQ(accuracy.matched, 1);
  EXPECT_EQ(accuracy.impact_time_error, 0.0);
  EXPECT_EQ(accuracy.count_difference, 0);
}

TEST(Accuracy, MatchesNothingFurtherThanHalfTheMeanTimeApart) {
  Outcome outcome = true_values();
  outcome.impacts[4].time = 5.875;
  const Accuracy accuracy = compare(scene(), outcome, true_values());
  EXPECT_EQ(accuracy.missed, 1);
  EXPECT_EQ(accuracy.spurious, 1);
  EXPECT_EQ(accuracy.matched, 3);
}

TEST(Accuracy, PairsAFastImpactWithOneThatIsALittleTooSlowToCount) {
  Outcome outcome = true_values();
  outcome.impacts[4].speed = 0.9;
  const Accuracy accuracy = compare(scene(), outcome, true_values());
  EXPECT_EQ(accuracy.missed, 0);
  EXPECT_EQ(accuracy.matched, 4);
  EXPECT_EQ(accuracy.count_difference, -1);
  const Accuracy reversed = compare(scene(), true_values(), outcome);
  EXPECT_EQ(reversed.spurious, 0);
  EXPECT_EQ(reversed.matched, 4);
  EXPECT_EQ(reversed.count_difference, 1);
}

TEST(Accuracy, IgnoresSlowImpacts) {
  Outcome outcome = true_values();
  outcome.impacts.erase(outcome.impacts.begin() + 3);
  outcome.impacts.push_back({7.5, Wall::upper, 0.4});
  const Accuracy accuracy = compare(scene(), outcome, true_values());
  EXPECT_EQ(accuracy.missed, 0);
  EXPECT_EQ(accuracy.spurious, 0);
  EXPECT_EQ(accuracy.matched, 4);
}

TEST(Accuracy, HasNoTimeErrorWithoutAPair) {
  const Accuracy accuracy = compare(scene(), outcome_of({}, 0.0), true_values());
  EXPECT_EQ(accuracy.missed, 4);
  EXPECT_EQ(accuracy.matched, 0);
  EXPECT_FALSE(accuracy.impact_time_error.has_value());
  EXPECT_EQ(accuracy.count_difference, -4);
}

}  // namespace
}  // namespace ricochet::carrier_track
