#include <gtest/gtest.h>

#include "src/analysis/export/formats.h"
#include "tests/support/numbers.h"

namespace ricochet::exports {
namespace {

/// Evaluations and optimality gaps of the rows.
std::vector<std::pair<std::int64_t, double>> rows(const std::vector<comparison::Step>& steps,
                                                  std::int64_t evaluations) {
  comparison::Outcome outcome;
  outcome.steps = steps;
  outcome.evaluations = evaluations;
  outcome.seconds = 7;
  std::vector<std::pair<std::int64_t, double>> all;
  for (const auto& row : best_so_far(outcome))
    all.emplace_back(row.evaluations, row.optimality_gap);
  return all;
}

using Rows = std::vector<std::pair<std::int64_t, double>>;

TEST(BestSoFar, BeginsAtTheFirstEvaluationAndEndsAtTheLast) {
  EXPECT_EQ(rows({{1, 0.1, 3}, {4, 0.2, 0.5}}, 9), (Rows{{1, 3}, {4, 0.5}, {9, 0.5}}));
  EXPECT_EQ(rows({{4, 0.2, 0.5}}, 9), (Rows{{1, 1e30}, {4, 0.5}, {9, 0.5}}));
  EXPECT_EQ(rows({{4, 0.2, 0.5}}, 4), (Rows{{1, 1e30}, {4, 0.5}}));
}

TEST(BestSoFar, IsOneRowOfARunOfOneEvaluationOrNone) {
  EXPECT_EQ(rows({{1, 0.1, 3}}, 1), (Rows{{1, 3}}));
  EXPECT_EQ(rows({}, 1), (Rows{{1, 1e30}}));
  EXPECT_EQ(rows({}, 0), (Rows{{1, 1e30}}));
}

TEST(BestSoFar, HasNoOptimalityGapTwiceAndNoneThatIsNoNumber) {
  EXPECT_EQ(rows({{2, 0, 3}, {3, 0, 3}, {3, 0, 2}, {3, 0, 1}}, 3),
            (Rows{{1, 1e30}, {2, 3}, {3, 1}}));
  EXPECT_EQ(rows({{2, 0, infinity}, {3, 0, -infinity}, {4, 0, std::nan("")}, {5, 0, 1e31}}, 6),
            (Rows{{1, 1e30}, {6, 1e30}}));
}

}  // namespace
}  // namespace ricochet::exports
