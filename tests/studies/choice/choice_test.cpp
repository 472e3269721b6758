#include "src/studies/choice/choice.h"

#include "src/experiment/planned_runs.h"
#include "tests/core/best_point_of.h"
#include "tests/studies/pages.h"
#include "tests/support/campaigns.h"
#include "tests/support/files.h"

namespace ricochet::studies::choice {
namespace {

Case a_case(const std::string& family, std::map<std::string, double> shares,
            const std::string& cluster = "") {
  return {"", family, cluster, rule_of_auto().data(), "a", std::move(shares)};
}

TEST(Standings, AreMeansOverFamilies) {
  const std::vector<Case> cases = {
      a_case("one", {{"a", 1}, {"b", 0.5}}), a_case("one", {{"a", 0}, {"b", 0.5}}),
      a_case("one", {{"a", 0}, {"b", 0.5}}), a_case("two", {{"a", 1}})};  // which b does not take
  const std::vector<Standing> order = standings(cases);
  ASSERT_EQ(order.size(), 2U);
  EXPECT_EQ(order[0].entry, "a");
  EXPECT_DOUBLE_EQ(order[0].mean, (1 / 3.0 + 1) / 2);
  EXPECT_DOUBLE_EQ(order[1].mean, 0.25);
  EXPECT_THAT(order[1].shares, testing::ElementsAre(0.5, 0.5, 0.5, 0));
}

TEST(Standings, SayHowOftenEachIsFirstWhenProblemsAreDrawnAgain) {
  const auto first = [](const std::vector<Case>& cases) {
    return probabilities_of_being_first(cases, standings(cases));
  };
  const std::vector<Case> alike = {a_case("one", {{"a", 1}, {"b", 1}, {"c", 0}})};
  EXPECT_THAT(first(alike), testing::ElementsAre(testing::DoubleNear(0.5, 1e-9),
                                                 testing::DoubleNear(0.5, 1e-9), 0));
  // a is first unless only the second of two problems is drawn: a probability of 3/4; where both
  // are drawn, a has 1/2 and b 0.4.
  const std::vector<Case> uneven = {a_case("one", {{"a", 1}, {"b", 0}}),
                                    a_case("one", {{"a", 0}, {"b", 0.8}})};
  EXPECT_NEAR(first(uneven)[0], 0.75, 0.05);
  EXPECT_NEAR(first(uneven)[0] + first(uneven)[1], 1, 1e-9);
  // Problems of one cluster are drawn together.
  std::vector<Case> together = uneven;
  for (Case& each : together) each.cluster = "both";
  EXPECT_NEAR(first(together)[0], 1, 1e-9);
}

class Choices : public TemporaryFolder {};

/// Asks only for the best point, or only for the lower end.
Solver knowing(const std::string& name, bool knows) {
  Solver solver;
  solver.name = name;
  solver.solve = [knows](Evaluator& evaluator, const Vector& start, Random&) {
    const Problem known = bowl(evaluator.name(), start.size());
    const Vector x = knows ? best_point_of(known, evaluator) : evaluator.lower();
    evaluator.objective(x);
    return SolverTermination{"done", x};
  };
  return solver;
}

TEST_F(Choices, AreMeasuredOnTheRunsOfACampaign) {
  Catalogue catalogue = made_up_catalogue();
  catalogue.families = {{"short", {bowl("short-1", 1), bowl("short-2", 2)}},
                        {"long", {bowl("long-8", 8)}}};
  // The rule chooses the first for one variable, the second for more.
  catalogue.solvers = {knowing("mads-tuned", true), knowing("nlopt-mlsl-bobyqa", false),
                       knowing("wise", true)};
  catalogue.solvers.push_back(knowing("auto", true));
  catalogue.solvers.back().chooses = true;
  const Campaign campaign = made_up_campaign(
      part_of("\"*\"", "solvers = [\"*\", \"auto\"]\ninstances = 3\nbudgets = [10, 100]"),
      catalogue);
  Store store = Store::create(folder_ / "runs.sqlite", campaign.description());
  make_runs(campaign, {}, store);
  const std::vector<Evidence> evidence = {
      {"these", campaign, comparison::cell_results(campaign, store)}};

  const std::vector<Case> cases = cases_of(evidence[0], all_settings()[1]);
  ASSERT_EQ(cases.size(), 3U);
  for (const Case& each : cases) {
    EXPECT_EQ(each.chosen, each.problem == "short-1" ? "mads-tuned" : "nlopt-mlsl-bobyqa");
    EXPECT_EQ(each.share_of(each.chosen), each.problem == "short-1" ? 1 : 0);
    EXPECT_EQ(each.share_of("wise"), 1);
    EXPECT_FALSE(each.shares.contains("auto")) << "it is one of the others";
  }

  const report::Results results = measured_choices(evidence);
  const Table& settings = *results.table("settings");
  const Row row = row_of(settings, "setting", all_settings()[1].title);
  EXPECT_DOUBLE_EQ(row.number("auto"), 0.25);
  EXPECT_DOUBLE_EQ(row.number("over_problems"), 1 / 3.0);
  EXPECT_EQ(row.text("single"), "mads-tuned");
  EXPECT_DOUBLE_EQ(row.number("single_share"), 1);
  EXPECT_DOUBLE_EQ(row.number("difference"), -0.75);
  EXPECT_LE(row.number("lower"), 0.25);
  EXPECT_GE(row.number("upper"), 0.25);
  // "short" learns of "long" that another entry is first, and the other way round.
  EXPECT_DOUBLE_EQ(row.number("left_out"), 1);
  EXPECT_THAT(study_page("choice", results).files.at("summary.md"), HasSubstr("mads-tuned"));
}

TEST_F(Choices, NeedRunsOfWhatTheRuleChooses) {
  Catalogue catalogue = made_up_catalogue();
  const Campaign campaign = made_up_campaign(part_of("\"bowl-1\""), catalogue);
  Store store = Store::create(folder_ / "runs.sqlite", campaign.description());
  make_runs(campaign, {}, store);
  EXPECT_THAT(
      [&] {
        measured_choices({{"these", campaign, comparison::cell_results(campaign, store)}});
      },
      testing::ThrowsMessage<InputError>(HasSubstr("none of the runs")));
}

}  // namespace
}  // namespace ricochet::studies::choice
