#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/suite/machine.h"

namespace ricochet::carrier_track {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// The fitted start and window are those of a short look at a carrier that was thrown in.
TEST(SceneDoubts, OfThePapersCasesAreAboutTheirStartAlone) {
  for (const Case& a_case : all_cases()) {
    EXPECT_THAT(doubts_about(scene_of(a_case, default_machine())),
                ElementsAre(HasSubstr("scene.start_velocity = 0.5987 m/s"),
                            HasSubstr("window: 1.38 turns")))
        << a_case.id;
  }
}

Scene plausible() {
  return parse_scene(
      "[scene]\nmass = 1.2\npath_radius = 0.065\nwall_lower = 0\nwall_upper = 0.8e-3\n"
      "restitution = 0.5\nfriction = 0.2\nnormal_force = 11.8\ndisturbance = 0.1\n"
      "start_position = 0\nomega = 6\n"
      "[window]\nrevolutions = 10\n[count]\ncounting_limit = 5e-3\n",
      "plausible");
}

std::vector<std::string> doubts_after(const std::function<void(Scene&)>& slip) {
  Scene scene = plausible();
  slip(scene);
  return doubts_about(scene);
}

TEST(SceneDoubts, NameEverySlip) {
  EXPECT_THAT(doubts_about(plausible()), testing::IsEmpty());
  const auto expect_one = [](const std::function<void(Scene&)>& slip, const std::string& said) {
    EXPECT_THAT(doubts_after(slip), ElementsAre(HasSubstr(said)));
  };
  expect_one(
      [](Scene& s) {
        s.mass = 1200, s.normal_force = 11772, s.friction = 0.01;
        s.centrifugal_mass_radius = 78;
      },
      "scene.mass = 1200 kg");
  expect_one(
      [](Scene& s) {
        s.mass = 1e-4, s.normal_force = 1e-3, s.centrifugal_mass_radius = 6.5e-6;
        s.disturbance = 0;
      },
      "scene.mass = 0.0001 kg");
  expect_one([](Scene& s) { s.wall_upper = s.wall_lower + 0.8; }, "are these millimetres?");
  expect_one([](Scene& s) { s.wall_upper = s.wall_lower + 0.02; }, "a fifth of the path radius");
  expect_one([](Scene& s) { s.wall_upper = 9e-7, s.counting_limit = 1e-3; }, "hardly any play");
  expect_one([](Scene& s) { s.normal_force = 0; }, "nothing to multiply");
  expect_one([](Scene& s) { s.normal_force = 120; }, "the weight is 11.77 N");
  expect_one([](Scene& s) { s.normal_force = 1.1; }, "the weight is 11.77 N");
  expect_one([](Scene& s) { s.friction = 1.1; }, "scene.friction = 1.1");
  expect_one([](Scene& s) { s.restitution_upper = 1; }, "scene.restitution = [0.5, 1]");
  expect_one([](Scene& s) { s.start_velocity = -9; }, "scene.start_velocity = -9 m/s");
  expect_one([](Scene& s) { s.disturbance_frequency = 0; }, "never changes");
  expect_one([](Scene& s) { s.counting_limit = 2; }, "count.counting_limit = 2 m/s");
  expect_one([](Scene& s) { s.omega = 300; }, "2865 turns a minute");
  expect_one([](Scene& s) { s.window = Seconds{0.5}; }, "0.477 turns");
  EXPECT_THAT(
      doubts_after([](Scene& s) { s.wall_upper = std::numeric_limits<double>::infinity(); }),
      testing::IsEmpty());
}

TEST(SceneDoubts, CompareConstantsWithEachOther) {
  EXPECT_THAT(doubts_after([](Scene& s) { s.centrifugal_mass_radius = 78; }),
              testing::Contains(HasSubstr("a path radius of 65 m, not within 0.01..1 m")));
  EXPECT_THAT(doubts_after([](Scene& s) { s.centrifugal_mass_radius = 0.0078; }),
              testing::Contains(HasSubstr("a path radius of 0.0065 m")));
  EXPECT_THAT(doubts_after([](Scene& s) { s.friction = 0.9, s.normal_force = 60; }),
              ElementsAre(HasSubstr("= 54 N: holds the carrier at every speed up to 18 rad/s")));
  EXPECT_THAT(doubts_after([](Scene& s) { s.friction = 5e-5, s.disturbance = 0; }),
              ElementsAre(HasSubstr("holds the carrier up to 0.087 rad/s (0.831 rpm) only")));
  // 18 rad/s: (0.078 18^2 + 0.1 - 2.36) N over 1.2 kg give 0.175 m/s in 0.8 mm.
  EXPECT_THAT(doubts_after([](Scene& s) { s.counting_limit = 0.18; }),
              ElementsAre(HasSubstr("only 0.175 m/s across the clearance")));
  EXPECT_THAT(doubts_after([](Scene& s) { s.counting_limit = 1e-6; }),
              ElementsAre(HasSubstr("rebounds count that nobody hears")));
  // 6 rad/s: (2.808 + 0.1 - 2.36) N give 0.027 m/s.
  EXPECT_THAT(doubts_after([](Scene& s) { s.start_velocity = -0.09; }),
              ElementsAre(HasSubstr("-0.09 m/s: at scene.omega = 6 rad/s the forces give the "
                                    "carrier 0.027 m/s across")));
  EXPECT_THAT(doubts_after([](Scene& s) { s.window = Revolutions{4}; }),
              ElementsAre(HasSubstr("window: 4 turns at scene.omega: the first impacts are")));
}

}  // namespace
}  // namespace ricochet::carrier_track
