#include "problems/carrier_track/questions/machine_grid.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/paper/fitted_reading.h"
#include "problems/carrier_track/questions/count.h"
#include "problems/carrier_track/questions/families.h"
#include "problems/carrier_track/questions/scanned_best.h"
#include "src/core/error.h"

namespace ricochet::carrier_track {
namespace {

const Question* found(const std::vector<Family>& families, const std::string& name) {
  for (const Family& family : families) {
    for (const Question& question : family.questions) {
      if (question.name() == name) return &question;
    }
  }
  return nullptr;
}

/// All of one grid in one test: to scan for best values takes a second or two.
TEST(MachineGrid, AsksOfEveryCombinationWhatItSays) {
  const auto families = grid_families("C4", {{0.25, 0.75}, {}, {0.5}});
  const double friction = find_case("C4").friction;
  const std::string id = fmt::format("C4-r0.75-f{}-d0.5", friction);
  std::set<std::string> machines;
  for (const Family& family : families) {
    for (const Question& question : family.questions) {
      machines.insert(question.machine);
      EXPECT_FALSE(question.stated.best_known) << question.name();
    }
  }
  EXPECT_EQ(machines, (std::set{id, fmt::format("C4-r0.25-f{}-d0.5", friction)}));

  const Question* count = found(families, "count-" + id);
  const Question* top_speed = found(families, "top-speed-" + id);
  ASSERT_NE(count, nullptr);
  ASSERT_NE(top_speed, nullptr);
  EXPECT_EQ(count->factors.at("restitution"), 0.75);
  EXPECT_EQ(count->factors.at("friction"), friction);
  EXPECT_EQ(count->factors.at("disturbance"), 0.5);
  const Scene scene = scene_of({"mine", 0.75, friction, 0.5, {}}, default_reading().scene);
  const Question same = count_question(machine_of(scene, "mine"));
  for (const Question* asked : {count, top_speed}) {
    const Question scanned = with_scanned_best(*asked);
    const Question* question = &scanned;
    ASSERT_TRUE(question->stated.best_known);
    for (double speed = 0.015; speed < 18; speed += 0.013) {
      const Vector x = Vector::Constant(1, speed);
      const Values values = question->stated.evaluate(x);
      if (asked == count) {
        EXPECT_EQ(values.objective, same.stated.evaluate(x).objective);
      }
      const bool feasible = values.constraints.size() == 0 || values.constraints.maxCoeff() <= 0;
      if (feasible) {
        EXPECT_GE(values.objective, *question->stated.best_known - question->tolerance) << speed;
      }
    }
  }
}

TEST(MachineGrid, SimulatesAtTheLevelThatItNames) {
  const auto families = grid_families("C1", {.fidelity = {"planar", "impact"}});
  const Question* planar = found(families, "count-C1-r0.1-f0.1-d0-planar");
  const Question* impact = found(families, "count-C1-r0.1-f0.1-d0-impact");
  ASSERT_NE(planar, nullptr);
  ASSERT_NE(impact, nullptr);
  EXPECT_EQ(planar->factors.at("fidelity"), 2);
  EXPECT_EQ(impact->factors.at("fidelity"), 0);
  EXPECT_FALSE(planar->stated.smoothed(0.1).differentiate);
  EXPECT_TRUE(impact->stated.smoothed(0.1).differentiate);
  const auto families_as_stated = grid_families("C1", {});
  const Question* same = found(families_as_stated, "count-C1-r0.1-f0.1-d0");
  ASSERT_NE(same, nullptr);
  EXPECT_FALSE(same->factors.contains("fidelity"));
  int differ = 0;
  for (double speed = 0.5; speed < 18; speed += 0.5) {
    const Vector x = Vector::Constant(1, speed);
    const double counted = impact->stated.evaluate(x).objective;
    EXPECT_EQ(counted, same->stated.evaluate(x).objective);
    differ += planar->stated.evaluate(x).objective == counted ? 0 : 1;
  }
  EXPECT_GT(differ, 0) << "the carrier rubs across";
}

TEST(MachineGrid, RefusesACaseThatIsNoneAndAMachineThatIsNone) {
  EXPECT_THROW(grid_families("C99", {}), InputError);
  EXPECT_THROW(grid_families("C1", {{1.5}}), InputError);
  EXPECT_THROW(grid_families("C1", {{}, {-0.5}}), InputError);
  EXPECT_THROW(grid_families("C1", {.fidelity = {"auto"}}), InputError);
}

}  // namespace
}  // namespace ricochet::carrier_track
