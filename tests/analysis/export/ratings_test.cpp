#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/analysis/export/formats.h"
#include "tests/analysis/export/exported_store.h"
#include "tests/analysis/export/rated.h"

namespace ricochet::exports {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::SizeIs;

using RatingsCsv = ExportedStore;

TEST_F(RatingsCsv, HaveARowForEveryFamilyAndEntry) {
  write_ratings({rated("count", 2), rated("nan", 1)}, out);
  EXPECT_THAT(lines_of(text_of(out / "ratings.csv")),
              ElementsAre("family,problems,budget_per_variable,solver,formulation,problems_taken,"
                          "problems_never_solved,solved_share,returned_solved_share,mean_rank,"
                          "probability_of_being_best",
                          "count,2,100,solver_0,original,2,0,1,1,1.25,0.75",
                          "count,2,100,solver_1,original,2,0,1,0.5,2.25,0.125",
                          "count,2,100,solver_2,original,0,0,1,0.3333333333333333,,",
                          "missing-value,2,100,solver_0,original,2,0,1,1,1.25,0.75",
                          "missing-value,2,100,solver_1,original,0,0,1,0.5,,"));
}

TEST_F(RatingsCsv, HaveTheirRuntimesAndTargets) {
  write_ratings({rated("count", 1)}, out);
  const std::vector<std::string> ecdf = lines_of(text_of(out / "ecdf.csv"));
  EXPECT_THAT(ecdf, SizeIs(1 + 2 * 2));
  EXPECT_THAT(ecdf, Contains("count,solver_0,original,100,0.5,0.2,0.8"));
  EXPECT_THAT(lines_of(text_of(out / "targets.csv")),
              ElementsAre("family,problem,target", "count,hs-1,0.5", "count,hs-1,1.5"));
}

}  // namespace
}  // namespace ricochet::exports
