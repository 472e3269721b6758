#include "src/analysis/comparison/reported_part.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "tests/experiment/campaign/made_up_campaign.h"

namespace ricochet::studies::comparison {
namespace {

std::vector<ReportedPart> reported(const std::string& plan) {
  const Campaign campaign(plan_from(plan, "test"), searched_catalogue(std::make_shared<int>(0)));
  return reported_parts(campaign);
}

const std::string bowls = part_of("\"bowl-[12]\"");
const std::string drawn = part_of("\"bowl-[12]\"", "drawn_machines = 2");

TEST(ReportedPart, IsNoneThatOnlyAsksForTheSameAsAnother) {
  const auto parts = reported(bowls + part_of("\"bowl-[12]\"", "seeds = 2") + drawn +
                              part_of("\"bowl-[12]\"", "relocated_optimum = true"));
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].part, 0U);
  EXPECT_EQ(parts[0].repetition, 1U);
  EXPECT_EQ(parts[0].drawn, 2U);
}

TEST(ReportedPart, RepeatsItselfWithItsOtherSeeds) {
  const auto parts = reported(part_of("\"bowl-[12]\"", "seeds = 2"));
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].repetition, 0U);
}

TEST(ReportedPart, IsOneOfDrawnMachinesWhereNoOtherAsksForTheSame) {
  const auto parts = reported(part_of("\"bowl-8\"") + drawn);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_FALSE(parts[0].drawn);
  EXPECT_EQ(parts[1].part, 1U);
  EXPECT_FALSE(parts[1].drawn) << "not of itself";
}

TEST(ReportedPart, MayComeBehindTheDrawnMachinesOfIt) {
  const auto parts = reported(drawn + bowls);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].part, 1U);
  EXPECT_EQ(parts[0].drawn, 0U);
}

}  // namespace
}  // namespace ricochet::studies::comparison
