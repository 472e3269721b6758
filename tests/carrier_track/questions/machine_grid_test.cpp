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

TEST(MachineGrid, HasAMachineForEveryCombination) {
  const auto families = grid_families("C1", {0.25, 0.5}, {}, {0, 1.5});
  const double friction = find_case("C1").friction;
  std::set<std::string> machines;
  for (const Family& family : families) {
    for (const Question& question : family.questions) machines.insert(question.machine);
  }
  std::set<std::string> expected;
  for (const std::string restitution : {"0.25", "0.5"}) {
    for (const std::string disturbance : {"0", "1.5"}) {
      expected.insert(fmt::format("C1-r{}-f{}-d{}", restitution, friction, disturbance));
    }
  }
  EXPECT_EQ(machines, expected);
}

TEST(MachineGrid, AsksOfEveryMachineWhatItSays) {
  const auto families = grid_families("C4", {0.75}, {0.125}, {0.5});
  const Question* count = found(families, "count-C4-r0.75-f0.125-d0.5");
  ASSERT_NE(count, nullptr);
  const Scene scene = scene_of({"mine", 0.75, 0.125, 0.5, {}}, default_reading().scene);
  const Question same = count_question(machine_of(scene, "mine"));
  for (double speed = 0.5; speed < 18; speed += 0.37) {
    const Vector x = Vector::Constant(1, speed);
    EXPECT_EQ(count->stated.evaluate(x).objective, same.stated.evaluate(x).objective) << speed;
  }
  EXPECT_EQ(count->factors.at("restitution"), 0.75);
  EXPECT_EQ(count->factors.at("friction"), 0.125);
  EXPECT_EQ(count->factors.at("disturbance"), 0.5);
}

TEST(MachineGrid, KnowsTheBestOfQuestionsOfOneVariable) {
  const auto families = grid_families("C1", {}, {}, {});
  int known = 0;
  for (const Family& family : families) {
    for (const Question& question : family.questions) {
      if (!question.stated.best_known) continue;
      EXPECT_EQ(question.stated.dimension(), 1) << question.name();
      ++known;
    }
  }
  EXPECT_GE(known, 2);
  for (const std::string family : {"top-speed-", "count-"}) {
    const Case own = find_case("C1");
    const Question* question = found(
        families,
        fmt::format("{}C1-r{}-f{}-d{}", family, own.restitution, own.friction, own.disturbance));
    ASSERT_NE(question, nullptr);
    ASSERT_TRUE(question->stated.best_known);
    // No point of a coarse scan of its own is better.
    for (double x = 0.015; x < 18; x += 0.013) {
      const Values values = question->stated.evaluate(Vector::Constant(1, x));
      const bool feasible = values.constraints.size() == 0 || values.constraints.maxCoeff() <= 0;
      if (feasible) {
        EXPECT_GE(values.objective, *question->stated.best_known - question->tolerance) << x;
      }
    }
  }
}

TEST(MachineGrid, RefusesACaseThatIsNoneAndAMachineThatIsNone) {
  EXPECT_THROW(grid_families("C99", {}, {}, {}), InputError);
  EXPECT_THROW(grid_families("C1", {1.5}, {}, {}), InputError);
  EXPECT_THROW(grid_families("C1", {}, {-0.5}, {}), InputError);
}

}  // namespace
}  // namespace ricochet::carrier_track
