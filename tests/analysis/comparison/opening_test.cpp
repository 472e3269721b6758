#include <gtest/gtest.h>

#include "src/analysis/comparison/sections.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

Json first(const std::string& family, const Json& solver, const Json& best, double returned = 0.5,
           bool largest = true) {
  return {{"family", family},     {"solver", solver}, {"best", best},
          {"returned", returned}, {"problems", 12},   {"largest", largest}};
}

TEST(Opening, SaysWhichSolverHowSureAndOnHowManyProblems) {
  EXPECT_EQ(
      opening_of({first("top-speed", "bisection", 1, 1), first("top-speed", "walk", 1, 1, false),
                  first("robust-mean", "bisection", 0.9, 0.92), first("hs", "ipopt", 0.89, 0.934),
                  first("count", nullptr, nullptr), first("hs-many", "slsqp", nullptr),
                  first("classic", "crs", 0.4), first("wear", "ipopt", 1, 0.02)}),
      "First with a probability P(best) of 0.9 or more on problems like these: bisection on "
      "top-speed, robust-mean "
      "(success rate 92 to 100 %, 24 problems). Less sure, P(best) of 0.5 to 0.9: "
      "ipopt on hs (success rate 93 %, 12 problems). On 4 of 7 kinds of problems no entry is "
      "named so: too few solve them, several are as good, or random search is enough.");
}

TEST(Opening, LeavesOutWhatThereIsNot) {
  EXPECT_EQ(opening_of(Json::array({first("hs", "ipopt", 0.95)})),
            "First with a probability P(best) of 0.9 or more on problems like these: ipopt on hs "
            "(success rate 50 %, 12 "
            "problems).");
  EXPECT_EQ(opening_of(Json::array()), "");
}

}  // namespace
}  // namespace ricochet::studies::comparison
