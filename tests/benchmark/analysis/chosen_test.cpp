#include "src/contest/chosen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/core/error.h"
#include "tests/contest/valley.h"

namespace ricochet::contest {
namespace {

TEST(Chosen, LeavesOutQuestionsWhoseBestValueIsNotKnown) {
  Question known = valley_question();
  Question unknown = valley_question();
  unknown.stated.name = "valley-2";
  unknown.stated.best_known.reset();
  EXPECT_EQ(chosen_questions({known, unknown}, "valley*", "--questions").size(), 1U);
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
}  // namespace ricochet::contest
