#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "src/experiment/planned_runs.h"
#include "tests/support/files.h"
#include "tests/experiment/campaign/made_up_campaign.h"

namespace ricochet {
namespace {

using testing::ElementsAre;

class Completenesses : public TemporaryFolder {
 protected:
  /// Of a store that has those of the campaign's runs, in the order of their lengths, that `keeps`
  /// returns true for; the first of them failed.
  Completeness with(const Campaign& campaign, const std::function<bool(std::size_t)>& keeps) {
    const std::filesystem::path file = folder_ / "runs.sqlite";
    std::filesystem::remove(file);
    const PlannedRuns planned(campaign, {}, {});
    Store::write(file, campaign.description(), [&](const Store::AddRun& add) {
      for (std::size_t k = 0; k < planned.all().size(); ++k) {
        RunRecord record;
        record.failure = k == 0 ? "it failed" : "";
        if (keeps(k)) add(planned.all()[k].key, record);
      }
    });
    return completeness_of(campaign, Store::open(file, Store::For::reading));
  }

  const Campaign campaign_ = campaign_of(
      part_of("\"bowl-[12]\"", "name = \"one\"\nsolvers = \"chance-*\"\ninstances = 3") +
      part_of("\"bowl-8\"", "name = \"other\"\ninstances = 3\nseeds = 2"));
};

TEST_F(Completenesses, CountRunsThatFailedAsPresent) {
  const Completeness whole = with(campaign_, [](std::size_t) { return true; });
  EXPECT_EQ(whole.planned, 2 * 2 * 3 + 3 * 2);
  EXPECT_EQ(whole.missing(), 0);
  EXPECT_FALSE(whole.is_in_doubt());
  EXPECT_EQ(in_words(whole), "all 18 planned runs are present");
}

TEST_F(Completenesses, NameMissingShards) {
  const Completeness found = with(campaign_, [](std::size_t k) { return k % 4 == 2; });
  EXPECT_EQ(found.present, 4);
  EXPECT_EQ(found.missing(), 14);
  EXPECT_EQ(found.missing_shards, "shards 1, 2, 4 of 4");
  EXPECT_EQ(with(campaign_, [](std::size_t k) { return k % 3 != 1; }).missing_shards,
            "shard 2 of 3");
}

TEST_F(Completenesses, SayOfWhatRunsAreMissingAfterAnInterruption) {
  const Completeness found = with(campaign_, [](std::size_t k) { return k < 12; });
  EXPECT_EQ(found.missing_shards, "") << "the longest runs are there";
  EXPECT_THAT(found.missing_problems, ElementsAre("bowl-1"));
  EXPECT_THAT(found.missing_solvers, ElementsAre("chance-a", "chance-b"));
  EXPECT_THAT(found.missing_instances, ElementsAre(1, 2, 3));
  ASSERT_EQ(found.parts.size(), 2U);
  EXPECT_EQ(found.parts[0].present, 6);
  EXPECT_EQ(found.parts[1].present, 6);
  EXPECT_EQ(
      in_words(found),
      "12 of 18 planned runs are present, 6 are missing: of bowl-1; of chance-a, chance-b; on "
      "instances 1, 2, 3; 6 of 12 of one");
}

TEST_F(Completenesses, OfNoRunAtAllNamesNoShard) {
  const Completeness found = with(campaign_, [](std::size_t) { return false; });
  EXPECT_EQ(found.missing(), 18);
  EXPECT_EQ(found.missing_shards, "");
}

TEST_F(Completenesses, NameAFewOfMany) {
  const Campaign many = campaign_of(part_of("\"bowl-1\"", "instances = 9"));
  EXPECT_THAT(in_words(with(many, [](std::size_t k) { return k == 0; })),
              testing::HasSubstr("on instances 2, 3, 4, 5, 6 and 3 more"));
}

TEST_F(Completenesses, DoubtSolversThatThisBuildLacks) {
  with(campaign_, [](std::size_t) { return true; });
  const Campaign smaller = campaign_of(part_of("\"bowl-[12]\"",
                                               "solvers = \"chance-a\""
                                               "\ninstances = 3"));
  const Completeness found =
      completeness_of(smaller, Store::open(folder_ / "runs.sqlite", Store::For::reading));
  EXPECT_EQ(found.missing(), 0);
  EXPECT_TRUE(found.is_in_doubt());
  EXPECT_EQ(
      in_words(found),
      "all 18 planned runs are present; further runs of chance-b may be missing: this build has "
      "no such solver");
}

}  // namespace
}  // namespace ricochet
