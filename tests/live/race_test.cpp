#include "src/live/race.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/counting/count_scan.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "src/core/evaluator.h"

namespace ricochet::live {
namespace {

using namespace carrier_track;

TEST(Race, MinimisesWhatTheSuiteDoes) {
  const Machine machine = all_machines().at(0);
  const Problem top_speed = top_speed_problem(machine);
  const Problem suite = penalised(top_speed, top_speed.penalty_weight);
  const Race race{machine.scene, machine.quiet_limit, suite.upper[0], 60};
  for (const Racer racer : {Racer::fireworks, Racer::random_search, Racer::cma_es}) {
    const std::vector<RaceStep> steps = steps_of(racer, race, 11);
    ASSERT_EQ(steps.size(), 60U);
    if (racer != Racer::cma_es) {
      EXPECT_EQ(steps.front().omega, suite.start[0]);
    }
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
  for (const Racer racer : {Racer::fireworks, Racer::random_search, Racer::cma_es}) {
    EXPECT_EQ(speeds(racer, 5), speeds(racer, 5));
    EXPECT_NE(speeds(racer, 5), speeds(racer, 6));
  }
}

TEST(Race, GoesOnWhereASolverHasConverged) {
  // Quiet everywhere: the strategy is at the end of the range soon, and begins again.
  Scene still;
  still.window = Seconds{1};
  const Race race{still, 0, 18, 2000};
  const std::vector<RaceStep> steps = steps_of(Racer::cma_es, race, 2);
  EXPECT_EQ(steps.size(), 2000U);
  EXPECT_EQ(std::ranges::max(steps, {}, &RaceStep::omega).omega, 18);
}

}  // namespace
}  // namespace ricochet::live
