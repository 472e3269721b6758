#include "src/campaign/campaign.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>
#include <string>

#include "src/campaign/runner.h"
#include "src/core/error.h"
#include "tests/campaign/made_up_catalogue.h"

namespace ricochet {
namespace {

using testing::HasSubstr;
using testing::UnorderedElementsAre;

Campaign campaign_of(const std::string& plan) {
  return {plan_from(plan, "test"), made_up_catalogue()};
}

std::string part_of(const std::string& questions, const std::string& rest = "") {
  return "[[part]]\nquestions = " + questions +
         (rest.find("solvers") == std::string::npos ? "\nsolvers = \"chance-a\"" : "") +
         (rest.find("budgets") == std::string::npos ? "\nbudgets = 10" : "") + "\n" + rest + "\n";
}

template <class Member>
std::set<std::string> names(const Campaign& campaign, Member member) {
  std::set<std::string> all;
  for (const PlannedCell& cell : campaign.cells()) all.insert(cell.cell.*member);
  return all;
}

TEST(Campaign, ChoosesQuestionsByPatternWhoseBestValueIsKnown) {
  const auto questions = [](const std::string& part) {
    return names(campaign_of(part), &Cell::question);
  };
  EXPECT_THAT(questions(part_of("\"bowl-*\"")), UnorderedElementsAre("bowl-1", "bowl-2", "bowl-8"));
  EXPECT_THAT(questions(part_of("[\"bowl-[12]\", \"cup-s\"]")),
              UnorderedElementsAre("bowl-1", "bowl-2", "cup-s"));
  EXPECT_THAT(questions(part_of("\"*\"", "variables = 2")),
              UnorderedElementsAre("bowl-2", "cup-2", "cup-smooth", "cup-s"));
  EXPECT_THAT(questions(part_of("\"*\"", "variables = [2, 8]\nconstrained = false")),
              UnorderedElementsAre("bowl-2", "bowl-8", "cup-s"));
  EXPECT_THAT(questions(part_of("\"*\"", "constrained = true")),
              UnorderedElementsAre("cup-2", "cup-smooth"))
      << "penalised, the solver takes them";
}

TEST(Campaign, ChoosesSolversFormsAndFeaturesByPattern) {
  const Campaign campaign = campaign_of(
      part_of("\"*\"",
              "solvers = [\"chance-*\"]\nforms = [\"*count\"]\nfeatures = [\"plain\", \"noisy\"]"));
  EXPECT_THAT(names(campaign, &Cell::solver), UnorderedElementsAre("chance-a", "chance-b"));
  EXPECT_THAT(names(campaign, &Cell::form), UnorderedElementsAre("count", "penalised-count"));
  EXPECT_THAT(names(campaign, &Cell::question), UnorderedElementsAre("cup-smooth", "cup-s"));
  EXPECT_THAT(names(campaign, &Cell::feature), UnorderedElementsAre("plain", "noisy"));
}

TEST(Campaign, AddsWidthsToWhatCanBeSmoothed) {
  const Campaign campaign =
      campaign_of(part_of("[\"cup-s\", \"bowl-1\"]", "widths = [0.125, 0.5]"));
  EXPECT_THAT(names(campaign, &Cell::form),
              UnorderedElementsAre("as-stated", "count", "surrogate", "surrogate-0.125"));
}

TEST(Campaign, HasAGradientAtItsPrice) {
  const Campaign campaign =
      campaign_of(part_of("\"bowl-8\"", "gradient_prices = [\"n\", \"measured\", 0, 5]"));
  ASSERT_EQ(campaign.cells().size(), 4U);
  EXPECT_EQ(campaign.cells()[0].budget.gradient_price, std::nullopt);
  EXPECT_EQ(campaign.cells()[1].budget.gradient_price, 3);
  EXPECT_EQ(campaign.cells()[2].budget.gradient_price, 0);
  EXPECT_EQ(campaign.cells()[3].budget.gradient_price, 5);
  EXPECT_EQ(campaign.cells()[3].cell.gradient_price, "5");
}

TEST(Campaign, SpendsABudgetForEachVariableAndCountsIt) {
  const Campaign campaign = campaign_of(
      part_of("[\"bowl-1\", \"bowl-8\"]", "budgets = [10, 20]\ninstances = 3\nseeds = 2"));
  ASSERT_EQ(campaign.cells().size(), 4U);
  EXPECT_EQ(campaign.cells()[3].budget.evaluations, 160);
  EXPECT_EQ(campaign.runs(), 4 * 6);
  EXPECT_EQ(campaign.work(), 6.0 * (10 + 20 + 8 * (80 + 160))) << "a simulation for each variable";
}

TEST(Campaign, HasACellOnceThatSeveralPartsAskFor) {
  const Campaign campaign = campaign_of(part_of("\"bowl-[12]\"", "instances = 5") +
                                        part_of("\"bowl-[28]\"", "instances = 2\nseeds = 3"));
  ASSERT_EQ(campaign.cells().size(), 3U);
  const PlannedCell& both = campaign.cells()[1];
  EXPECT_EQ(both.cell.question, "bowl-2");
  EXPECT_EQ(both.parts, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(both.instances, 5);
  EXPECT_EQ(both.seeds, 3);
  EXPECT_EQ(campaign.runs(), 5 + 15 + 6);
}

TEST(Campaign, AsksQuestionsOfAGridInPlaceOfTheSuites) {
  const Campaign campaign =
      campaign_of(part_of("\"bowl-*\"", "machines = {around = \"C1\", restitution = [0.25, 0.5]}"));
  EXPECT_THAT(names(campaign, &Cell::question),
              UnorderedElementsAre("bowl-C1-0.250000", "bowl-C1-0.500000"));
}

std::string complaint(const std::string& plan) {
  try {
    campaign_of(plan);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(Campaign, RefusesAPatternThatNothingFits) {
  EXPECT_THAT(
      complaint(part_of("[\"bowl-1\", \"bwl-2\"]")),
      testing::AllOf(HasSubstr("part 1, questions bwl-2: nothing fits"), HasSubstr("bowl-2")));
  EXPECT_THAT(complaint(part_of("\"bowl-open\"")), HasSubstr("nothing fits"));
  EXPECT_THAT(complaint(part_of("\"bowl-1\"") + part_of("\"bowl-1\"", "solvers = [\"lucky\"]")),
              HasSubstr("part 2, solvers lucky: nothing fits"));
  EXPECT_THAT(complaint(part_of("\"bowl-1\"", "features = \"noise\"")),
              HasSubstr("part 1, features noise: nothing fits"));
}

TEST(Campaign, RefusesAPartOfWhichNothingIsLeft) {
  EXPECT_THAT(complaint(part_of("\"bowl-1\"", "variables = 2")), HasSubstr("part 1: none of"));
  EXPECT_THAT(complaint(part_of("\"cup-2\"", "forms = \"as-stated\"")), HasSubstr("part 1: none"));
  EXPECT_THAT(complaint(part_of("\"bowl-1\"", "forms = \"surrogate\"")), HasSubstr("part 1: none"));
}

TEST(Campaign, TakesSolversOfTheUsersOwn) {
  const Campaign campaign = campaign_of(part_of("\"bowl-1\"", "solvers = [\"./mine\", \"luck\"]") +
                                        part_of("\"bowl-2\"", "solvers = \"./mine\""));
  EXPECT_THAT(names(campaign, &Cell::solver), UnorderedElementsAre("mine", "luck"));
  EXPECT_EQ(campaign.solvers().size(), 2U);
}

TEST(Campaign, RefusesTwoSolversOfOneName) {
  const std::string said = "there is another solver of its name";
  EXPECT_THAT(complaint(part_of("\"bowl-1\"", "solvers = [\"./luck\"]")), HasSubstr(said));
  EXPECT_THAT(complaint(part_of("\"bowl-1\"", "solvers = [\"./a/mine\", \"./b/mine\"]")),
              HasSubstr("part 1, solvers ./b/mine: " + said));
  EXPECT_THAT(complaint(part_of("\"bowl-1\"", "solvers = \"./a/mine\"") +
                        part_of("\"bowl-2\"", "solvers = \"./b/mine\"")),
              HasSubstr("part 2, solvers ./b/mine: " + said));
}

TEST(Campaign, DescribesWhatItsRunsAreJudgedBy) {
  const CampaignDescription description =
      campaign_of(part_of("[\"bowl-2\", \"cup-2\"]")).description();
  ASSERT_EQ(description.questions.size(), 2U);
  EXPECT_EQ(description.questions[1].family, "cup");
  EXPECT_EQ(description.questions[1].constraints, 1);
  EXPECT_EQ(description.questions[0].variables, 2);
  ASSERT_EQ(description.solvers.size(), 1U);
  EXPECT_EQ(description.solvers[0].version, "1");
  EXPECT_EQ(description.plan, text_of(plan_from(description.plan, "again")));
}

std::vector<RunKey> keys_of(const PlannedRuns& runs) {
  std::vector<RunKey> keys;
  for (const PlannedRun& run : runs.all()) keys.push_back(run.key);
  return keys;
}

TEST(PlannedRuns, OfShardsAreDisjointAndCompleteWhateverIsDone) {
  const Campaign campaign = campaign_of(part_of(
      "\"*\"", "solvers = \"*\"\nfeatures = \"*\"\ninstances = 4\nseeds = 2\nbudgets = [3, 7]"));
  const auto whole = keys_of(PlannedRuns(campaign, {}, {}));
  EXPECT_EQ(static_cast<std::int64_t>(whole.size()), campaign.runs());
  const std::set<RunKey> every(whole.begin(), whole.end());
  ASSERT_EQ(every.size(), whole.size());
  std::mt19937_64 random(1);
  for (const int count : {1, 2, 3, 7, 1000}) {
    std::set<RunKey> seen;
    for (int index = 1; index <= count; ++index) {
      std::set<RunKey> done;  // by this shard, before
      for (const RunKey& key : whole) {
        if (random() % 3 == 0) done.insert(key);
      }
      const auto all = keys_of(PlannedRuns(campaign, {index, count}, {}));
      auto left = keys_of(PlannedRuns(campaign, {index, count}, done));
      for (const RunKey& key : all) {
        EXPECT_TRUE(seen.insert(key).second) << name_of(key);
        const bool is_left = std::find(left.begin(), left.end(), key) != left.end();
        EXPECT_NE(is_left, done.contains(key));
      }
      EXPECT_LE(left.size(), all.size());
    }
    EXPECT_EQ(seen, every) << count;
  }
}

TEST(PlannedRuns, BeginWithTheLongest) {
  const Campaign campaign = campaign_of(part_of("\"bowl-*\"", "budgets = [5, 50]"));
  const PlannedRuns planned(campaign, {}, {});
  EXPECT_TRUE(std::is_sorted(planned.all().begin(), planned.all().end(),
                             [](const auto& a, const auto& b) { return a.length > b.length; }));
  EXPECT_EQ(planned.all().front().length, 8.0 * 8 * 50);
}

TEST(PlannedRuns, AreSeededByAllThatTheyAreCalled) {
  const Campaign campaign = campaign_of(part_of(
      "\"cup-s\"", "solvers = \"*\"\nfeatures = [\"plain\", \"noisy\"]\ninstances = 2\nseeds = 2"));
  const PlannedRuns planned(campaign, {}, {});
  std::vector<Job> jobs;
  for (const PlannedRun& run : planned.all()) jobs.push_back(run.job);
  std::set<std::uint64_t> seeds;
  run_all(jobs, {}, [&](std::size_t j, const RunRecord& record) {
    EXPECT_TRUE(seeds.insert(record.seed).second) << name_of(planned.all()[j].key);
    EXPECT_EQ(record.instance, planned.all()[j].key.instance);
    EXPECT_EQ(record.run, planned.all()[j].key.run);
  });
  EXPECT_EQ(static_cast<std::int64_t>(seeds.size()), campaign.runs());
}

}  // namespace
}  // namespace ricochet
