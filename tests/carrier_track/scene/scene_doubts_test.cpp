#include "problems/carrier_track/scene/scene_doubts.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "problems/carrier_track/problems/cases.h"
#include "problems/carrier_track/problems/default_machine.h"

namespace ricochet::carrier_track {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(SceneDoubts, AreNoneOfThePapersCases) {
  for (const Case& a_case : all_cases()) {
    EXPECT_THAT(doubts_about(scene_of(a_case, default_machine())), testing::IsEmpty()) << a_case.id;
  }
}

TEST(SceneDoubts, NameEverySlip) {
  const Scene good = scene_of(find_case("C9"), default_machine());
  const std::string weight = fmt::format("the weight is {:.4g} N", good.mass * 9.81);
  const auto expect_one = [&](const std::function<void(Scene&)>& slip, const std::string& said) {
    Scene scene = good;
    slip(scene);
    EXPECT_THAT(doubts_about(scene), ElementsAre(HasSubstr(said)));
  };
  expect_one([](Scene& s) { s.mass = 1200, s.normal_force = 11772; }, "scene.mass = 1200 kg");
  expect_one([](Scene& s) { s.mass = 1e-4, s.normal_force = 1e-3; }, "scene.mass = 0.0001 kg");
  expect_one([](Scene& s) { s.wall_upper = s.wall_lower + 0.8; }, "are these millimetres?");
  expect_one(
      [](Scene& s) {
        s.wall_upper = s.wall_lower + 1e-7;
        s.start_position = s.wall_lower;
      },
      "hardly any play");
  expect_one([](Scene& s) { s.normal_force = 0; }, "nothing to multiply");
  expect_one([](Scene& s) { s.normal_force = 1200; }, weight);
  expect_one([](Scene& s) { s.normal_force = 1.2; }, weight);
  expect_one([](Scene& s) { s.friction = 3; }, "scene.friction = 3");
  expect_one([](Scene& s) { s.restitution_upper = 1; }, "scene.restitution = [0.1, 1]");
  expect_one([](Scene& s) { s.start_velocity = -9; }, "scene.start_velocity = -9 m/s");
  expect_one([](Scene& s) { s.disturbance_frequency = 0; }, "never changes");
  expect_one([](Scene& s) { s.counting_limit = 2; }, "count.counting_limit = 2 m/s");
  expect_one([](Scene& s) { s.omega = 300; }, "2865 turns a minute");
  expect_one([](Scene& s) { s.window = Seconds{0.5}; }, "0.239 turns");
  Scene open = good;
  open.wall_upper = std::numeric_limits<double>::infinity();
  EXPECT_THAT(doubts_about(open), testing::IsEmpty());
}

}  // namespace
}  // namespace ricochet::carrier_track
