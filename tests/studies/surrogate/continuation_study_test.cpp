#include "src/studies/surrogate/continuation_study.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace ricochet::studies::surrogate {
namespace {

const ContinuationStudy& study() {
  static const ContinuationStudy made = study_continuation({1, {200}});
  return made;
}

TEST(Guidance, HasARowForEveryClaimedCaseAndSolver) {
  std::map<std::string, int> rows;
  for (const Guidance& row : study().rows) ++rows[row.solver];
  ASSERT_EQ(rows.size(), 4U);
  for (const auto& [solver, count] : rows) EXPECT_EQ(count, 10) << solver;
}

TEST(Guidance, CallsARunSolvedThatCameWithinTheTolerance) {
  for (const Guidance& row : study().rows) {
    EXPECT_EQ(row.solved == 1, row.worst_regret <= speed_tolerance) << row.id << " " << row.solver;
    EXPECT_EQ(row.exit.empty(), row.solved == 1) << row.id << " " << row.solver;
  }
}

TEST(Guidance, HelpsSlsqpToTheFastestQuietSpeed) {
  std::map<std::string, int> solved;
  for (const Guidance& row : study().rows) solved[row.solver] += row.solved;
  EXPECT_GE(solved["continuation-nlopt-slsqp"], 9);
  EXPECT_LE(solved["nlopt-slsqp"], 5);
}

TEST(Guidance, ShowsEverySolverInATable) {
  const report::Section section = continuation_section(study());
  EXPECT_EQ(section.tables[0].columns.size(), 1U + 4U);
  EXPECT_EQ(section.tables[0].rows.size(), 10U + 1U);
}

}  // namespace
}  // namespace ricochet::studies::surrogate
