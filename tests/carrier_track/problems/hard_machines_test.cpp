#include "problems/carrier_track/questions/hard_machines.h"

#include <gtest/gtest.h>

#include <map>

#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/questions/speed_problem.h"
#include "problems/carrier_track/scene/scene_file.h"
#include "src/core/error.h"
#include "src/core/verdict.h"

namespace ricochet::carrier_track {
namespace {

TEST(HardMachines, AreReadAsTheyWereWritten) {
  const std::vector<HardMachine>& all = hard_machines();
  const HardMachines found =
      parse_hard_machines(write_hard_machines(found_hard_machines()), "text");
  EXPECT_EQ(write_fitted_reading(found.reading),
            write_fitted_reading(found_hard_machines().reading));
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
  const FittedReading& reading = found_hard_machines().reading;
  const std::string empty = write_hard_machines({reading, {}});
  EXPECT_TRUE(parse_hard_machines(empty, "text").machines.empty());
  for (const char* text : {"01 = 3", "[01]\naround = \"C1\"", "[01]\naround = 1"}) {
    EXPECT_THROW(parse_hard_machines(empty + text, "text"), InputError) << text;
  }
  EXPECT_THROW(parse_hard_machines("# no reading", "text"), InputError);
  std::string text = write_hard_machines({reading, {hard_machines()[0]}});
  text.replace(text.find("mass = "), 7, "mass = -");
  EXPECT_THROW(parse_hard_machines(text, "text"), InputError);
}

TEST(HardMachines, AreFifteenTheHardestFirstNoMoreThanFiveAroundACase) {
  const std::vector<HardMachine>& all = hard_machines();
  ASSERT_EQ(all.size(), 15U);
  std::map<std::string, int> around;
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_LE(++around[all[k].around], 5);
    EXPECT_GE(pocket_share(all[k]), 1e-3);
    EXPECT_LE(pocket_share(all[k]), 1e-2);
    EXPECT_LE(pocket_share(all[k == 0 ? 0 : k - 1]), pocket_share(all[k]));
    EXPECT_GE(all[k].hardness.pockets, 2);
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

TEST(HardMachines, AreAskedInEveryFormOfATopSpeed) {
  const Family family = hard_family();
  ASSERT_EQ(family.questions.size(), hard_machines().size());
  EXPECT_EQ(family.questions[0].name(), "hard-top-speed-01");
  EXPECT_EQ(family.questions[0].machine, "hard-01");
  for (std::size_t k = 0; k < family.questions.size(); ++k) {
    const Question& question = family.questions[k];
    ASSERT_EQ(question.forms().size(), 4U);
    for (const Form& form : question.forms()) {
      const Problem problem = question.problem(form);
      const Truth truth = truth_at(problem, problem.best_point.value());
      EXPECT_EQ(truth.violation, 0) << question.name();
      EXPECT_EQ(truth.objective, problem.best_known) << question.name();
    }
  }
}

}  // namespace
}  // namespace ricochet::carrier_track
