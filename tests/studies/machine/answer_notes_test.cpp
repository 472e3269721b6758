#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "src/studies/machine/answer.h"

namespace ricochet::studies::advice {
namespace {

using namespace carrier_track;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

Scene resting() {
  return parse_scene(
      "[scene]\nmass = 1.2\npath_radius = 0.065\nwall_lower = 0\nwall_upper = 0.8e-3\n"
      "restitution = 0.2\nfriction = 0.2\nnormal_force = 11.8\nstart_position = 0\n"
      "[window]\nrevolutions = 10\n[count]\ncounting_limit = 5e-3\n",
      "resting");
}

TEST(AnswerNotes, SayBothUnits) {
  EXPECT_EQ(both_units(3.14159265358979), "3.142 rad/s (30.00 rpm)");
}

TEST(AnswerNotes, NameTheRestitutionOfBothWallsIfTheyDiffer) {
  Scene scene = resting();
  EXPECT_THAT(notes_on(scene, {}), Not(Contains(HasSubstr("Restitution"))));
  scene.restitution_upper = 0.7;
  EXPECT_THAT(notes_on(scene, {}),
              Contains(HasSubstr("Restitution is 0.2 at the lower wall and 0.7 at the upper.")));
}

/// By hand: sqrt((friction normal_force + |pull| - |disturbance|) / |centrifugal_mass_radius -
/// slider_mass_radius|).
TEST(AnswerNotes, SayUpToWhatSpeedFrictionHolds) {
  Scene scene = resting();
  EXPECT_THAT(notes_on(scene, {}), Contains(HasSubstr("Friction holds the carrier still up to "
                                                      "5.501 rad/s (52.53 rpm).")));
  scene.slider_mass_radius = 0.02;
  scene.pull = 0.5;
  scene.disturbance = 0.3;
  EXPECT_THAT(notes_on(scene, {}), Contains(HasSubstr("up to 6.644 rad/s (63.44 rpm).")));
  scene.centrifugal = Centrifugal::inward;
  scene.disturbance = 0;
  EXPECT_THAT(notes_on(scene, {}), Contains(HasSubstr("hold the carrier still at every speed")));
  scene.friction = 0;
  EXPECT_THAT(notes_on(scene, {}), testing::IsEmpty());
}

TEST(AnswerNotes, WarnOfAWindowWhoseCollisionsAreTheStarts) {
  Scene scene = resting();
  EXPECT_LE(start_share(scene, 6).of_start, 1);
  EXPECT_THAT(notes_on(scene, start_share(scene, 6)), Not(Contains(HasSubstr("window"))));
  scene.window = Revolutions{1.25};
  scene.start_velocity = 0.6;  // then 0.11 m/s, after which friction stops it
  const StartShare share = start_share(scene, 4);
  EXPECT_NEAR(share.turns, 1.25, 1e-12);
  EXPECT_EQ(share.count, 2);
  EXPECT_EQ(share.of_start, 2);
  EXPECT_THAT(
      notes_on(scene, share),
      Contains(HasSubstr("The window of 1.25 turns is short: 2 of its 2 collisions at 4.000 rad/s "
                         "(38.20 rpm) are the start's, and do not come again.")));
  scene.window = Revolutions{100};  // where as many collisions do not matter
  EXPECT_GE(start_share(scene, 7).of_start, 2);
  EXPECT_THAT(notes_on(scene, start_share(scene, 7)), Not(Contains(HasSubstr("window"))));
}

TEST(AnswerNotes, TakeTheSpeedAtWhichTheStartCausesMost) {
  Scene scene = resting();
  EXPECT_FALSE(largest_start_share(scene, {}).has_value());
  scene.window = Revolutions{1.25};
  scene.start_velocity = 0.6;
  const StartShare slow = start_share(scene, 2);
  const StartShare fast = start_share(scene, 7);
  ASSERT_NE(slow.of_start, fast.of_start);
  const double most = slow.of_start > fast.of_start ? 2 : 7;
  EXPECT_EQ(largest_start_share(scene, {7, 2}).value().omega, most);
  EXPECT_EQ(largest_start_share(scene, {2, 7}).value().omega, most);
}

}  // namespace
}  // namespace ricochet::studies::advice
