#include "src/live/race.h"

#include "problems/carrier_track/counting/count_scan.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "src/core/evaluator.h"
#include "tests/support/scenes.h"
#include "tests/support/test.h"

namespace ricochet::live {
namespace {

using namespace carrier_track;

constexpr std::array all_racers = {Racer::fireworks, Racer::random_search, Racer::bisection};

TEST(Race, MinimisesWhatTheSuiteDoes) {
  const Machine machine = all_machines().at(0);
  const Problem top_speed = top_speed_problem(machine);
  const Problem alone = penalised(top_speed, top_speed.penalty_weight);
  const Race race{machine.scene, machine.quiet_limit, top_speed.upper[0], 60};
  for (const Racer racer : all_racers) {
    const bool constrained = racer == Racer::bisection;
    const Problem& suite = constrained ? top_speed : alone;
    const std::vector<RaceStep> steps = steps_of(racer, race, 11);
    ASSERT_EQ(steps.size(), 60U);
    EXPECT_EQ(steps[constrained ? 2 : 0].omega, suite.start[0]);
    for (const RaceStep& step : steps) {
      EXPECT_EQ(step.count, counts(machine.scene, {&step.omega, 1}).front());
      EXPECT_EQ(step.value, suite.evaluate(Vector::Constant(1, step.omega)).objective);
    }
  }
}

TEST(Race, IsTheSameAgainAndAnotherWithAnotherSeed) {
  const Machine machine = all_machines().at(1);
  const Race race{machine.scene, machine.quiet_limit, 18, 40};
  const auto speeds = [&](Racer racer, std::uint64_t seed) {
    std::vector<double> result;
    for (const RaceStep& step : steps_of(racer, race, seed)) result.push_back(step.omega);
    return result;
  };
  for (const Racer racer : all_racers) {
    EXPECT_EQ(speeds(racer, 5), speeds(racer, 5));
    EXPECT_NE(speeds(racer, 5), speeds(racer, 6));
  }
}

TEST(Race, GoesOnWhereASolverHasConverged) {
  // Quiet everywhere: bisection is done after both ends of the range, and begins again.
  const Race race{with(Scene{}, set::seconds(1)), 0, 18, 2000};
  const std::vector<RaceStep> steps = steps_of(Racer::bisection, race, 2);
  EXPECT_EQ(steps.size(), 2000U);
  EXPECT_EQ(std::ranges::max(steps, {}, &RaceStep::omega).omega, 18);
  EXPECT_EQ(goal_of(race), 18);
}

TEST(Race, HasTheSuitesSolutionAsItsGoalWhateverTheSeed) {
  EXPECT_FALSE(goal_of({all_machines().at(0).scene, -1, 18})) << "nothing is quiet";
  // The suite's best known values are of scan_completely(), which misses no quiet window.
  for (const Machine& machine : all_machines()) {
    const Problem suite = top_speed_problem(machine);
    ASSERT_TRUE(suite.best_known) << machine.id;
    const Race race{machine.scene, machine.quiet_limit, suite.upper[0], 100};
    const std::optional<double> goal = goal_of(race);
    ASSERT_TRUE(goal) << machine.id;
    EXPECT_NEAR(*goal, -*suite.best_known, 1e-5) << machine.id;
    for (const Racer racer : all_racers) {
      for (const std::uint64_t seed : {1, 2, 3}) {
        for (const RaceStep& step : steps_of(racer, race, seed)) {
          EXPECT_TRUE(step.count > machine.quiet_limit || step.omega <= *goal + 1e-6) << machine.id;
        }
      }
    }
  }
}

}  // namespace
}  // namespace ricochet::live
