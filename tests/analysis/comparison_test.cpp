#include <gtest/gtest.h>

#include "src/analysis/results.h"
#include "tests/analysis/held_campaign.h"

namespace ricochet::comparison {
namespace {

/// One solver on one problem in 2 of its formulations, at 2 prices of a gradient, by two parts.
class Compared : public HeldCampaign {
 protected:
  void SetUp() override {
    HeldCampaign::SetUp();
    Catalogue catalogue;
    catalogue.families = {{"valley", {valley_problem()}}};
    catalogue.solvers = {patient("quick", 3)};
    catalogue.solvers.front().content = "a user's, which may ask for gradients";
    const std::string asked =
        "[[part]]\nproblems = \"*\"\nsolvers = \"*\"\nbudgets = 10\ngradient_prices = [0, "
        "\"n\"]\n";
    campaign_.emplace(plan_from(asked + "instances = 5\n" + asked + "instances = 2\nseeds = 3\n" +
                                    "formulations = \"count\"\n",
                                "test"),
                      catalogue);
    store_.emplace(Store::create(folder_ / "runs.sqlite", campaign_->description()));
    make_runs(*campaign_, {}, *store_);
    results_ = cell_results(*campaign_, *store_);
  }

  std::vector<CellResult> results_;
};

TEST_F(Compared, AreResultsOfOnePartUnderTheSameConditions) {
  ASSERT_EQ(results_.size(), 4U);
  const Comparison comparison = comparison_of(*campaign_, results_, {});
  ASSERT_EQ(comparison.results.size(), 2U) << "two formulations at the price n";
  EXPECT_EQ(comparison.problems(), (std::vector<std::size_t>{0}));
  for (const CellResult& result : comparison.results) {
    EXPECT_EQ(result.cell->cell.gradient_price, "n");
    ASSERT_EQ(result.outcomes.size(), 5U);
    EXPECT_EQ(result.outcomes[4].instance, 5);
    EXPECT_EQ(comparison.problem_of(result).name, "valley");
  }
}

TEST_F(Compared, HaveOneOutcomeAnInstanceOfTheRunThatIsAskedFor) {
  const Comparison again = comparison_of(*campaign_, results_, {.part = 1, .run = 2});
  ASSERT_EQ(again.results.size(), 1U) << "the other formulation has no third run";
  const CellResult& result = again.results.front();
  EXPECT_EQ(result.cell->seeds, 3);
  ASSERT_EQ(result.outcomes.size(), 2U);
  EXPECT_EQ(result.outcomes[1].instance, 2);
  for (const CellResult& whole : results_) {
    if (whole.cell == result.cell) {
      EXPECT_EQ(&result.outcomes[1], &whole.outcomes[5]);
    }
  }
}

}  // namespace
}  // namespace ricochet::comparison
