#include "problems/carrier_track/suite/hard_machines.h"

#include <gtest/gtest.h>

#include <map>

#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/error.h"
#include "ricochet/machine.h"
#include "ricochet/run.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track {
namespace {

TEST(HardMachines, AreReadAsTheyWereWritten) {
  const std::vector<HardMachine>& all = hard_machines();
  const HardMachines found =
      parse_hard_machines(write_hard_machines(found_hard_machines()), "text");
  EXPECT_EQ(write_scene(found.constants), write_scene(found_hard_machines().constants));
  const std::vector<HardMachine>& read = found.machines;
  ASSERT_EQ(read.size(), all.size());
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_EQ(read[k].around, all[k].around);
    EXPECT_EQ(read[k].draw, all[k].draw);
    EXPECT_EQ(read[k].machine.id, all[k].machine.id);
    EXPECT_EQ(read[k].machine.quiet_limit, all[k].machine.quiet_limit);
    EXPECT_EQ(write_scene(read[k].machine.scene), write_scene(all[k].machine.scene));
    EXPECT_EQ(read[k].best.value, all[k].best.value);
    EXPECT_EQ(read[k].best.point, all[k].best.point);
    EXPECT_EQ(read[k].best.provenance, all[k].best.provenance);
    EXPECT_EQ(read[k].hardness, all[k].hardness);
  }
}

TEST(HardMachines, RefuseWhatIsNoSuchText) {
  const Scene& constants = found_hard_machines().constants;
  const std::string empty = write_hard_machines({constants, {}});
  EXPECT_TRUE(parse_hard_machines(empty, "text").machines.empty());
  for (const char* text : {"01 = 3", "[01]\naround = \"C1\"", "[01]\naround = 1"}) {
    EXPECT_THROW(parse_hard_machines(empty + text, "text"), InputError) << text;
  }
  EXPECT_THROW(parse_hard_machines("# no constants", "text"), InputError);
  std::string text = write_hard_machines({constants, {hard_machines()[0]}});
  text.replace(text.rfind("\nmass = "), 8, "\nmass = -");
  EXPECT_THROW(parse_hard_machines(text, "text"), InputError);
}

TEST(HardMachines, AreFifteenTheHardestFirstNoMoreThanFiveAroundACase) {
  const std::vector<HardMachine>& all = hard_machines();
  ASSERT_EQ(all.size(), 15U);
  std::map<std::string, int> around;
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_LE(++around[all[k].around], 5);
    EXPECT_GE(quiet_interval_share(all[k]), 1e-3);
    EXPECT_LE(quiet_interval_share(all[k]), 1e-2);
    EXPECT_LE(quiet_interval_share(all[k == 0 ? 0 : k - 1]), quiet_interval_share(all[k]));
    EXPECT_GE(all[k].hardness.quiet_intervals, 2);
    EXPECT_GT(all[k].hardness.bisection_gap, speed_tolerance);
  }
}

TEST(HardMachines, AskForASpeedWhoseCountAndThoseNextToItAreCertain) {
  for (const HardMachine& hard : hard_machines()) {
    const double best = hard.best.point[0];
    for (const double off : {-1e-4, 0.0, 1e-4}) {
      const Recording recording = record(at_speed(hard.machine.scene, best + off), 0.25, 0);
      EXPECT_TRUE(recording.certainty.certain) << hard.machine.id << ' ' << off;
      EXPECT_EQ(recording.count <= hard.machine.quiet_limit, off <= 0) << hard.machine.id;
    }
  }
}

TEST(HardMachines, AreAskedInEveryFormulationOfATopSpeed) {
  const Family family = hard_family();
  ASSERT_EQ(family.problems.size(), hard_machines().size());
  EXPECT_EQ(family.problems[0].name, "hard-top-speed-01");
  EXPECT_EQ(family.problems[0].machine, "hard-01");
  for (std::size_t k = 0; k < family.problems.size(); ++k) {
    const Problem& problem = family.problems[k];
    ASSERT_EQ(problem.formulations().size(), 4U);
    for (const Formulation& formulation : problem.formulations()) {
      const Problem formulated = problem.formulated(formulation);
      const TrueValues true_values = true_values_at(formulated, formulated.best_point.value());
      EXPECT_EQ(true_values.violation, 0) << problem.name;
      EXPECT_EQ(true_values.objective, formulated.best_known) << problem.name;
    }
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
