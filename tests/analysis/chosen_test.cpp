#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ricochet/error.h"
#include "src/analysis/outcomes.h"
#include "tests/analysis/valley.h"

namespace ricochet::comparison {
namespace {

TEST(Chosen, LeavesOutProblemsWhoseBestValueIsNotKnown) {
  Problem known = valley_problem();
  Problem unknown = valley_problem();
  unknown.name = "valley-2";
  unknown.best_known.reset();
  EXPECT_EQ(chosen_problems({known, unknown}, "valley*", "--problems").size(), 1U);
}

TEST(Chosen, SaysWhatMayHaveBeenMeant) {
  const std::vector<Solver> solvers = {patient("scan", 1), patient("cobyla", 1)};
  try {
    chosen_solvers(solvers, "coblya", "--solvers");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("--solvers coblya"),
                                             testing::HasSubstr("cobyla")));
  }
}

}  // namespace
}  // namespace ricochet::comparison
