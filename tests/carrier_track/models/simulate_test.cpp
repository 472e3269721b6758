#include "problems/carrier_track/motion/simulate.h"

#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <stdexcept>
#include <vector>

#include "problems/carrier_track/check/random_scenes.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "tests/support/scenes.h"

namespace ricochet::carrier_track {
namespace {

Scene compliant(double stiffness) {
  Scene scene = scene_of(find_case("C4"), exploratory_scene());
  scene.omega = 5;
  scene.fidelity = Fidelity::compliant;
  scene.contact_law = ContactLaw::exact_restitution;
  scene.stiffness = stiffness;
  return scene;
}

TEST(Simulate, FollowsTheFidelityOfTheScene) {
  Scene hard = compliant(1e18);
  hard.fidelity = Fidelity::impact;
  const int count = record(hard, 0.25, 0).count;
  EXPECT_EQ(record(compliant(1e18), 0.25, 0).count, count);
  EXPECT_NE(record(compliant(1e8), 0.25, 0).count, count) << "a soft wall is another machine";
}

TEST(Simulate, RecordsThePathInACompliantWall) {
  const Recording recording = record(compliant(1e10), 0.25, 200);
  double deepest = 0;
  double last = 0;
  for (const Sample& s : recording.path) {
    deepest = std::min(deepest, s.position);
    EXPECT_GE(s.time, last - 1e-12);
    last = s.time;
  }
  EXPECT_LT(deepest, -1e-6);
}

TEST(Simulate, RefusesASceneThatLeavesItsLevelOpen) {
  Scene open = compliant(1e10);
  open.fidelity = Fidelity::automatic;
  Observer nobody;
  EXPECT_THROW(simulate(open, nobody), std::invalid_argument);
  open.profile = {{0.0, 2.0}};
  EXPECT_THROW(simulate(open, nobody), std::invalid_argument);
}

TEST(Simulate, HasNoDerivativesInACompliantWall) {
  EXPECT_THROW(surrogate_slope(compliant(1e8), 0.25), std::invalid_argument);
}

/// Pressed across by the pull's other part, which adds to the normal force.
Scene planar(double pull) {
  Scene scene = compliant(1e8);
  scene.fidelity = Fidelity::planar;
  scene.across.emplace().pull = pull;
  scene.across->start_position = 1;
  return scene;
}

TEST(Simulate, MovesInTwoDirectionsAtFidelityPlanar) {
  Scene alone = planar(0);
  alone.fidelity = Fidelity::impact;
  const int count = record(alone, 0.25, 0).count;
  EXPECT_EQ(record(planar(0), 0.25, 0).count, count);
  alone.normal_force += 1.5;
  EXPECT_EQ(record(planar(1.5), 0.25, 0).count, record(alone, 0.25, 0).count);
  EXPECT_NE(record(planar(1.5), 0.25, 0).count, count);
}

TEST(Simulate, HasNoDerivativesInTwoDirections) {
  EXPECT_THROW(surrogate_slope(planar(1), 0.25), std::invalid_argument);
}

/// Turning points off the walls, as they are told and as they are seen between stretches: where one
/// led to a wall that was not struck, and the next does not. Those of motions that are lost in
/// rounding are left out.
struct Turns : Observer {
  struct Turn {
    double time, position;
    bool operator==(const Turn&) const = default;
  };

  explicit Turns(const Scene& scene) : scene_(scene) {}

  void impact(double /*time*/, Wall wall, double /*speed*/) {
    if (ahead_ == wall) ahead_.reset();
  }

  void turn(double time, double position, Wall ahead) { add(told, time, position, ahead); }

  template <class Path>
  void stretch(double time, const Path& path, double duration) {
    if (ahead_ && !((*ahead_ == Wall::upper ? 1 : -1) * path.velocity > 0)) {
      add(seen, time, path.position, *ahead_);
    }
    ahead_.reset();
    const double velocity = path.velocity != 0 ? path.velocity : path.at(0.5 * duration).velocity;
    if (velocity != 0) ahead_ = velocity > 0 ? Wall::upper : Wall::lower;
    lost_ = path.at(duration).position == path.position && path.at(1.0).velocity != 0;
  }

  std::vector<Turn> told, seen;

 private:
  void add(std::vector<Turn>& turns, double time, double position, Wall ahead) {
    const double distance =
        ahead == Wall::upper ? scene_.wall_upper - position : position - scene_.wall_lower;
    if (distance > 0 && !lost_ && time < duration_of(scene_)) turns.push_back({time, position});
  }

  const Scene& scene_;
  std::optional<Wall> ahead_;
  bool lost_ = false;  // whether the last stretch was a flight that led nowhere
};

TEST(Simulate, TellsTheTurningPointsThatStretchesShow) {
  std::map<Fidelity, std::size_t> turns;
  for (int i = 0; i < 2000; ++i) {
    Scene scene = hostile_scene(11, i).scene;
    scene.stiffness = 1e6 * scene.mass;
    scene.across.emplace().pull = i % 7 - 3;
    scene.across->start_velocity = 1;
    for (const Fidelity level : {Fidelity::impact, Fidelity::compliant, Fidelity::planar}) {
      scene.fidelity = level;
      SCOPED_TRACE(i);
      Turns observer(scene);
      try {
        simulate(scene, observer);
      } catch (const std::runtime_error&) {  // too long
        continue;
      }
      ASSERT_EQ(observer.told, observer.seen);
      turns[level] += observer.told.size();
    }
  }
  EXPECT_EQ(turns.size(), 3U);
  for (const auto& [level, told] : turns) EXPECT_GT(told, 1000U);
}

}  // namespace
}  // namespace ricochet::carrier_track
