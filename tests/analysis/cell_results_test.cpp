#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ricochet/error.h"
#include "src/analysis/results.h"
#include "tests/analysis/held_campaign.h"

namespace ricochet::comparison {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

class CellResults : public HeldCampaign {};

TEST_F(CellResults, AreOfEveryCellWithWhatEveryRunSpentUntilItSolved) {
  hold({patient("quick", 3), patient("slow", 30), patient("steep", 5, true)}, "[10, 40]", 4);
  const auto results = cell_results(*campaign_, *store_);
  ASSERT_EQ(results.size(), 2U * (2 + 2 + 1)) << "two budgets, two formulations but for the last";
  for (const CellResult& result : results) {
    const Cell& cell = result.cell->cell;
    ASSERT_EQ(result.outcomes.size(), 4U) << cell.solver;
    for (std::size_t i = 0; i < 4; ++i) {
      const Outcome& outcome = result.outcomes[i];
      EXPECT_EQ(outcome.instance, static_cast<int>(i) + 1);
      EXPECT_EQ(outcome.evaluations, cell.budget);
      EXPECT_EQ(outcome.verdict.solved, cell.solver != "slow" || cell.budget == 40)
          << cell.formulation;
      if (cell.solver != "quick") continue;
      EXPECT_EQ(outcome.verdict.evaluations_to_solve, 4);
      EXPECT_FALSE(outcome.verdict.returned_solved) << "it hands over the end of the box";
    }
  }
}

TEST_F(CellResults, TellOfEveryRunThatIsRead) {
  hold({patient("quick", 3)}, "10", 3);
  int runs = 0;
  cell_results(*campaign_, *store_, [&](const StoredRun&) { ++runs; });
  EXPECT_EQ(runs, 2 * 3);
}

TEST_F(CellResults, AreThoseOfAWholeCampaign) {
  hold({patient("quick", 3)}, "10", 3, {1, 2});
  EXPECT_THAT([&] { cell_results(*campaign_, *store_); },
              ThrowsMessage<InputError>(HasSubstr("3 of 6 runs are there")));
}

TEST_F(CellResults, KnowTheLargestBudgetOfAProblem) {
  hold({patient("quick", 3)}, "[10, 40]", 1);
  const auto largest = largest_budgets(cell_results(*campaign_, *store_));
  EXPECT_EQ(largest, (std::map<std::size_t, std::int64_t>{{0, 40}}));
}

}  // namespace
}  // namespace ricochet::comparison
