#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/error.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {
namespace {

TEST(Cases, AreTwelveOfDistinctIdAndConstants) {
  std::set<std::string> ids;
  std::set<std::vector<double>> constants;
  for (const Case& c : all_cases()) {
    ids.insert(c.id);
    constants.insert({c.restitution, c.friction, c.disturbance});
  }
  EXPECT_EQ(all_cases().size(), 12U);
  EXPECT_EQ(ids.size(), 12U);
  EXPECT_EQ(constants.size(), 12U) << "every combination of 2 x 2 x 3 values";
}

TEST(Cases, ClaimThresholdsBetweenTheSpeedsOfTheirFigures) {
  int claims = 0;
  for (const Case& c : all_cases()) {
    ASSERT_EQ(c.claim.threshold.has_value(), c.claim.figure.has_value()) << c.id;
    ASSERT_EQ(c.claim.threshold.has_value(), c.claim.quiet_count.has_value()) << c.id;
    if (!c.claim.threshold) continue;
    EXPECT_LT(c.claim.figure->quiet, *c.claim.threshold) << c.id;
    EXPECT_GT(c.claim.figure->loud, *c.claim.threshold) << c.id;
    EXPECT_EQ(c.claim.figure->number, 5 + claims) << "figures 5 to 14 follow the cases";
    ++claims;
  }
  EXPECT_EQ(claims, 10);
}

TEST(Cases, ClaimThatBouncierIsLouderSooner) {
  // Conclusion (A): at equal friction and disturbance the threshold falls as restitution rises.
  for (const Case& dull : all_cases()) {
    for (const Case& bouncy : all_cases()) {
      if (!dull.claim.threshold || !bouncy.claim.threshold) continue;
      if (dull.friction != bouncy.friction || dull.disturbance != bouncy.disturbance) continue;
      if (dull.restitution < bouncy.restitution) {
        EXPECT_GT(*dull.claim.threshold, *bouncy.claim.threshold) << dull.id << " " << bouncy.id;
      }
    }
  }
}

TEST(Cases, AreFoundByTheirId) {
  EXPECT_EQ(find_case("C11").restitution, 0.9);
  EXPECT_EQ(find_case("C11").disturbance, 1.0);
  EXPECT_EQ(find_case("C3").claim.threshold, 13.0);
  try {
    find_case("C13");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("C13"));
    EXPECT_THAT(error.what(), testing::HasSubstr("did you mean C1 or C3"));
  }
}

TEST(Cases, PutTheirConstantsIntoAInterpretation) {
  const Scene interpretation = exploratory_scene();
  const Scene scene = scene_of(find_case("C8"), interpretation);
  EXPECT_EQ(scene.restitution_lower, 0.9);
  EXPECT_EQ(scene.restitution_upper, 0.9);
  EXPECT_EQ(scene.friction, 0.4);
  EXPECT_EQ(scene.disturbance, 0.1);
  EXPECT_EQ(scene.pull, interpretation.pull);
  EXPECT_EQ(scene.counting_limit, interpretation.counting_limit);
  EXPECT_EQ(scene.wall_upper, interpretation.wall_upper);
}

}  // namespace
}  // namespace ricochet::carrier_track
