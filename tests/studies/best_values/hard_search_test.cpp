#include <gtest/gtest.h>

#include <cmath>

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/machine.h"
#include "ricochet/run.h"
#include "ricochet/scene.h"
#include "solvers/library_solvers.h"
#include "src/studies/best_values/best_values.h"

namespace ricochet::studies::best_values {
namespace {

using namespace carrier_track;

/// What a loop over all multiples of the step finds: the fastest quiet speed, and how often a loud
/// speed is followed by a quiet one.
struct Found {
  double fastest = 0;
  int returns = 0;
};

Found look_everywhere(const Machine& machine, double step) {
  Found found;
  const SpeedScan scan = scan_speeds(machine.scene, step, fastest_speed);
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    if (scan.counts[k] > machine.quiet_limit) continue;
    found.fastest = scan.omega(k);
    if (k > 0 && scan.counts[k - 1] > machine.quiet_limit) ++found.returns;
  }
  return found;
}

TEST(HardSearch, DrawsTheSameMachineAgain) {
  const Machine machine = random_machine(default_machine(), "C9", 7);
  EXPECT_NO_THROW(check(machine.scene, "random"));
  EXPECT_EQ(write_scene(machine.scene),
            write_scene(random_machine(default_machine(), "C9", 7).scene));
  EXPECT_NE(write_scene(machine.scene),
            write_scene(random_machine(default_machine(), "C9", 8).scene));
  EXPECT_EQ(machine.quiet_limit, quiet_limit(quiet_count(machine.scene, Claim{}, ScanOptions{})));
}

/// The file is of these draws; std::pow may round its last digit otherwise elsewhere.
TEST(HardSearch, DrewTheMachinesOfTheFile) {
  for (const HardMachine& hard : hard_machines()) {
    const Machine drawn = random_machine(found_hard_machines().constants, hard.around, hard.draw);
    const Scene& scene = hard.machine.scene;
    EXPECT_EQ(drawn.quiet_limit, hard.machine.quiet_limit) << hard.machine.id;
    EXPECT_NEAR(drawn.scene.mass, scene.mass, 1e-12 * scene.mass) << hard.machine.id;
    EXPECT_NEAR(drawn.scene.disturbance, scene.disturbance, 1e-10) << hard.machine.id;
    EXPECT_NEAR(drawn.scene.phase, scene.phase, 1e-12) << hard.machine.id;
  }
}

TEST(HardSearch, FoundTheFastestQuietSpeedBeyondLoudOnes) {
  constexpr double step = 1e-3;
  for (const HardMachine& hard : hard_machines()) {
    const Found found = look_everywhere(hard.machine, step);
    EXPECT_LE(found.fastest, hard.best.point[0]) << hard.machine.id;
    EXPECT_GT(found.fastest, hard.best.point[0] - step) << hard.machine.id;
    EXPECT_GE(found.returns, 1) << hard.machine.id;
  }
}

TEST(HardSearch, KeepsWhatBisectionMissesFromBothEndsAndTheMiddle) {
  // Sixteen halvings, to less than a thirtieth of the tolerance, and no second start.
  const Budget budget{18};
  for (const HardMachine& hard : hard_machines()) {
    Problem problem = hard_top_speed_problem(hard);
    for (const double share : {0.0, 0.5, 1.0}) {
      problem.start = problem.lower + share * (problem.upper - problem.lower);
      const RunRecord record = run(problem, bisection(), budget, 0);
      ASSERT_TRUE(record.failure.empty()) << record.failure;
      EXPECT_FALSE(judge(record, problem, problem.tolerance).solved)
          << problem.name << " from " << share;
    }
  }
}

TEST(HardSearch, LeavesOutTheMachinesOfThePaper) {
  EXPECT_FALSE(judged_hard(all_machines()[0]));
}

/// Every true objective again, on a grid as fine as that of the search; of one machine, since to
/// judge it takes ten seconds.
TEST(HardSearch, JudgesAMachineAsItsFileSays) {
  const HardMachine& hard = hard_machines().at(5);
  const Found found = look_everywhere(hard.machine, 1e-4);
  EXPECT_NEAR(found.fastest, hard.best.point[0] - 0.5e-4, 0.5e-4);
  const auto again = judged_hard(hard.machine);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->best.value, hard.best.value);
  EXPECT_EQ(again->best.provenance, hard.best.provenance);
  EXPECT_EQ(again->hardness, hard.hardness);
}

}  // namespace
}  // namespace ricochet::studies::best_values
