#include "src/research/limits/goal_search.h"

#include <gtest/gtest.h>

#include "ricochet/solvers.h"
#include "tests/research/limits/usual_fit.h"

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;

Target least_error() {
  return {"error", true, [](const CoarseJudgement& j) { return goals_of(j).threshold_error; }};
}

GoalSearch some_goal_search(int seed, bool from_held) {
  const Fit fit = usual_fit();
  return {{fit.interpretation, {Unknown::start_velocity, Unknown::counting_limit}, fit.constants},
          least_error(),
          solver_named("nlopt-crs2"),
          seed,
          30,
          from_held};
}

TEST(GoalSearch, EndsWithTheLowestItsTargetHasHad) {
  FitStore store(no_file_yet());
  const auto found =
      searched({some_goal_search(1, false), some_goal_search(2, false), some_goal_search(1, true)},
               "test", store);
  ASSERT_EQ(found.size(), 3U);
  for (const GoalFound& f : found) {
    EXPECT_DOUBLE_EQ(f.whole.loss, value_of(least_error(), f.whole));
    EXPECT_DOUBLE_EQ(f.half.loss, value_of(least_error(), f.half));
    EXPECT_LE(f.whole.loss, f.half.loss);
    EXPECT_LE(f.half.loss, value_of(least_error(), usual_fit()));
    EXPECT_EQ(f.whole.constants[0], usual_fit().constants[0]) << "held";
  }
}

TEST(GoalSearch, LooksAtTheBestAfterAHalf) {
  FitStore store(no_file_yet());
  GoalSearch shorter = some_goal_search(1, false);
  shorter.parameterisation.held[static_cast<std::size_t>(Unknown::counting_limit)] = 0.1;
  GoalSearch longer = shorter;
  longer.evaluations *= 4;
  shorter.evaluations *= 2;
  const auto found = searched({shorter, longer}, "test", store);
  EXPECT_EQ(found[1].half.constants, found[0].whole.constants);
  EXPECT_LT(found[1].whole.loss, found[0].half.loss);
}

TEST(GoalSearch, GoesOnFromTheStoreToTheSameBits) {
  const auto file = no_file_yet();
  FitStore store(file);
  const std::vector<GoalSearch> searches = {some_goal_search(1, false)};
  const auto found = searched(searches, "test", store);
  const auto written = std::filesystem::last_write_time(file);
  FitStore again(file);
  const auto known = searched(searches, "test", again);
  EXPECT_EQ(std::filesystem::last_write_time(file), written);
  EXPECT_EQ(known[0].whole.constants, found[0].whole.constants);
  EXPECT_EQ(known[0].half.constants, found[0].half.constants);
  FitStore other(no_file_yet());
  EXPECT_EQ(searched(searches, "test", other)[0].whole.constants, found[0].whole.constants);
}

TEST(GoalSearch, KnowsItsFreedoms) {
  const Parameterisation parameterisation = parameterisation_of(
      Interpretation{},
      {Unknown::counting_limit, Unknown::contact_speed, Unknown::pull, Unknown::seconds});
  EXPECT_EQ(parameterisation.free, (std::vector{Unknown::pull, Unknown::counting_limit}));
  EXPECT_EQ(parameterisation.held, natural_constants());
}

}  // namespace
}  // namespace ricochet::studies::limits
