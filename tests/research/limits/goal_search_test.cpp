#include "src/studies/limits/goal_search.h"

#include <gtest/gtest.h>

#include "src/core/error.h"
#include "tests/studies/limits/usual_fit.h"

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;

Target least_error() {
  return {"error", true, [](const CoarseJudgement& j) { return goals_of(j).threshold_error; }};
}

GoalSearch some_goal_search(int seed, bool from_held) {
  const Fit fit = usual_fit();
  return {{fit.reading, {Open::start_velocity, Open::slowest}, fit.constants},
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
    EXPECT_DOUBLE_EQ(f.whole.misfit, value_of(least_error(), f.whole));
    EXPECT_DOUBLE_EQ(f.half.misfit, value_of(least_error(), f.half));
    EXPECT_LE(f.whole.misfit, f.half.misfit);
    EXPECT_LE(f.half.misfit, value_of(least_error(), usual_fit()));
    EXPECT_EQ(f.whole.constants[0], usual_fit().constants[0]) << "held";
  }
}

TEST(GoalSearch, LooksAtTheBestAfterAHalf) {
  FitStore store(no_file_yet());
  GoalSearch shorter = some_goal_search(1, false);
  shorter.freedom.held[static_cast<std::size_t>(Open::slowest)] = 0.1;
  GoalSearch longer = shorter;
  longer.evaluations *= 4;
  shorter.evaluations *= 2;
  const auto found = searched({shorter, longer}, "test", store);
  EXPECT_EQ(found[1].half.constants, found[0].whole.constants);
  EXPECT_LT(found[1].whole.misfit, found[0].half.misfit);
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

TEST(GoalSearch, KnowsItsSolversAndFreedoms) {
  EXPECT_THROW(solver_named("magic"), InputError);
  const Freedom freedom =
      freedom_of(Reading{}, {Open::slowest, Open::contact_speed, Open::pull, Open::seconds});
  EXPECT_EQ(freedom.freed, (std::vector{Open::pull, Open::slowest}));
  EXPECT_EQ(freedom.held, natural_constants());
}

}  // namespace
}  // namespace ricochet::studies::limits
