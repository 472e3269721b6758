#include "solvers/fireworks/varied_fireworks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "solvers/fireworks/bare_bones_fireworks.h"
#include "solvers/fireworks/fireworks_family.h"
#include "src/core/error.h"
#include "tests/solvers/fireworks/asked_points.h"
#include "tests/solvers/test_problems.h"

namespace ricochet::fireworks {
namespace {

using testing::HasSubstr;

TEST(Varied, AsksForTheSameAsItsOwnWhereNothingIsVaried) {
  for (const Solver& own : family()) {
    if (own.name == "fireworks-as-printed") continue;
    const Solver same = varied(own.name, own.name, {});
    EXPECT_EQ(asked_points(sphere(3, 7), same, 700), asked_points(sphere(3, 7), own, 700))
        << own.name;
    EXPECT_EQ(same.version, own.version + ", " + own.name);
  }
}

TEST(Varied, AsksForAnotherThingWithEveryOption) {
  const std::map<std::string, std::map<std::string, double>> options = {
      {"efwa", {{"fireworks", 3}, {"sparks", 20}, {"gaussian_sparks", 0}, {"amplitude", 1}}},
      {"dynfwa",
       {{"fireworks", 3}, {"sparks", 20}, {"amplitude", 1}, {"growth", 2}, {"decline", 0.5}}},
      {"bbfwa", {{"sparks", 20}, {"growth", 2}, {"decline", 0.5}}},
      {"lotfwa",
       {{"fireworks", 3},
        {"sparks", 20},
        {"guiding_share", 0.5},
        {"growth", 2},
        {"decline", 0.5}}}};
  for (const auto& [of, each] : options) {
    const auto own = asked_points(sphere(3, 7), varied(of, "mine", {}), 2000);
    for (const auto& [option, value] : each) {
      const Solver solver = varied(of, "mine", {{option, value}});
      EXPECT_NE(asked_points(sphere(3, 7), solver, 2000), own) << of << ' ' << option;
    }
  }
}

TEST(Varied, IsWhatItsOptionsSay) {
  BareBonesFireworksOptions options;
  options.sparks = 17;
  options.steps.growth = 1.5;
  const Solver solver = varied("bbfwa", "mine", {{"sparks", 17}, {"growth", 1.5}});
  EXPECT_EQ(asked_points(sphere(3, 7), solver, 500),
            asked_points(sphere(3, 7), bare_bones_fireworks("mine", options), 500));
  EXPECT_EQ(solver.name, "mine");
  EXPECT_THAT(solver.version, testing::EndsWith(", bbfwa growth 1.5 sparks 17"));
}

std::string complaint(const std::string& of, const std::map<std::string, double>& options) {
  try {
    varied(of, "mine", options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(Varied, RefusesWhatCannotBe) {
  EXPECT_THAT(complaint("mads", {}), HasSubstr("mads: no such solver has options; "));
  EXPECT_THAT(complaint("bbfwa", {{"spark", 3}}),
              HasSubstr("spark: bbfwa has no such option; did you mean sparks?"));
  EXPECT_THAT(complaint("bbfwa", {{"amplitude", 3}}), HasSubstr("has no such option"));
  EXPECT_THAT(complaint("bbfwa", {{"sparks", 0}}),
              HasSubstr("sparks = 0: must be a whole number from 1 to 1000000"));
  EXPECT_THAT(complaint("bbfwa", {{"sparks", 1.5}}), HasSubstr("a whole number"));
  EXPECT_THAT(complaint("lotfwa", {{"guiding_share", 2}}), HasSubstr("a number from 0.001 to 1"));
  EXPECT_THAT(complaint("efwa", {{"sparks", 3}}), HasSubstr("fewest * sparks"));
}

}  // namespace
}  // namespace ricochet::fireworks
