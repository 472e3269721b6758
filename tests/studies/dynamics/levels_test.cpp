#include <gtest/gtest.h>

#include <numeric>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/suite/machine.h"
#include "src/studies/dynamics/fidelity.h"

namespace ricochet::studies::dynamics {
namespace {

TEST(Levels, AddUpAndNeedTheSecondDirectionWhereFrictionCannotHold) {
  // In the default interpretation friction on the weight, 11.8 N, holds 1.2 N with the coefficient
  // 0.1 of C1 and 4.7 N with 0.4 of C3. The yarn pulls across with these shares of its pull along
  // x.
  const double pull = carrier_track::default_machine().pull;
  const LevelStudy study = study_levels({2, {0, 3 / pull, 6 / pull}, 1.5e10, 3});
  ASSERT_EQ(study.rows.size(), 12U);
  for (const LevelRow& row : study.rows) {
    EXPECT_EQ(row.speeds, 9);
    EXPECT_EQ(std::accumulate(row.doubts.begin(), row.doubts.end(), 0), row.speeds);
    EXPECT_LE(row.resolved, row.speeds - row.certain);
    EXPECT_EQ(row.coupled[0], 0);
    EXPECT_EQ(row.wrong[0], 0);
    const bool slippery = row.id == "C1" || row.id == "C2" || row.id == "C5" || row.id == "C6" ||
                          row.id == "C9" || row.id == "C10";
    EXPECT_EQ(row.coupled[1], slippery ? row.speeds : 0) << row.id;
    EXPECT_EQ(row.coupled[2], row.speeds) << row.id;
    for (const double seconds : row.seconds) EXPECT_GT(seconds, 0);
  }
}

/// Without a pull across nothing couples, so that the planar level counts what hard walls do, with
/// the friction on their own force.
TEST(Levels, AreOfThePapersMachines) {
  using namespace carrier_track;
  for (const Case& the_case : all_cases()) {
    Scene scene = level_scene(the_case, 0, 1.5e10);
    for (double omega = 1; omega <= 18; omega += 1) {
      const int counted = count_at(scene_of(the_case, default_machine()), omega);
      scene.fidelity = Fidelity::impact;
      EXPECT_EQ(count_at(scene, omega), counted) << the_case.id << " at " << omega;
      scene.fidelity = Fidelity::planar;
      EXPECT_EQ(count_at(scene, omega), counted) << the_case.id << " at " << omega;
    }
  }
}

TEST(Levels, AreTheSameEveryTimeButForTheTimes) {
  const LevelPlan plan{4, {1}, 1.5e10, 4};
  const LevelStudy one = study_levels(plan);
  const LevelStudy other = study_levels(plan);
  for (std::size_t c = 0; c < one.rows.size(); ++c) {
    EXPECT_EQ(one.rows[c].doubts, other.rows[c].doubts);
    EXPECT_EQ(one.rows[c].wrong, other.rows[c].wrong);
  }
}

}  // namespace
}  // namespace ricochet::studies::dynamics
