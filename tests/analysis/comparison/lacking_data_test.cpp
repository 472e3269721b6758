#include <gtest/gtest.h>

#include "src/analysis/comparison/order.h"

namespace ricochet::studies::comparison {
namespace {

using report::Json;

const std::vector<MissingSolver> missing = {{"dlib-global-search", "dlib", {}},
                                            {"tao-brgn", "TAO", {}}};

Json lacking(const std::string& solvers) {
  return lacking_data(
      plan_from("[[part]]\nproblems = \"*\"\nsolvers = [" + solvers + "]\nbudgets = 1\n", "test"),
      missing);
}

TEST(Lacking, AreTheMissingSolversThatThePlanSelects) {
  const Json all = lacking("\"*\"");
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0]["solver"], "dlib-global-search");
  EXPECT_EQ(all[0]["library"], "dlib");
  EXPECT_EQ(lacking("\"mads\", \"tao-*\""), (Json{{{"solver", "tao-brgn"}, {"library", "TAO"}}}));
}

TEST(Lacking, AreNoneIfThePlanSelectsOthersOrAllAreThere) {
  EXPECT_EQ(lacking("\"mads\""), Json::array());
  EXPECT_EQ(
      lacking_data(plan_from("[[part]]\nproblems = \"*\"\nsolvers = \"*\"\nbudgets = 1\n", "test"),
                   {}),
      Json::array());
}

}  // namespace
}  // namespace ricochet::studies::comparison
