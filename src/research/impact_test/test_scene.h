#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/recording.h"
#include "ricochet/scene.h"
#include "src/report/json.h"

/// The test that simulators of impacts are measured by: scenes with their true impacts, the tools
/// that simulate them, and scores.
namespace ricochet::studies::impact_test {

using carrier_track::Scene;
using carrier_track::Wall;

/// The version of the scenes: it changes with what is drawn, with the truth, and with the score.
inline constexpr int suite_version = 1;

/// A force (a0 + a1 u + a2 u^2) cos(p0 + p1 u + p2 u^2), u [s] since the start of its segment.
struct ForceTerm {
  std::array<double, 3> amplitude;  ///< a0 [N], a1 [N/s], a2 [N/s^2]
  std::array<double, 3> phase;      ///< p0 [rad], p1 [rad/s], p2 [rad/s^2]
};
RICOCHET_JSON(ForceTerm, amplitude, phase);

/// The force from a time on, until the next segment: the sum of its terms.
struct ForceSegment {
  double from;  ///< [s]
  std::vector<ForceTerm> terms;
};
RICOCHET_JSON(ForceSegment, from, terms);

/// A scene as a tool reads it: mass x'' = F(t) - friction sign(x') between the walls, with
/// x' -> -restitution x' at a wall. The format is that of docs/impact-test.md.
struct TestScene {
  int version = suite_version;
  std::string scene;            ///< its name
  std::string kind;             ///< of scene_kinds()
  int difficulty = 1;           ///< 1 to difficulties
  double mass = 1;              ///< [kg]
  double lower = 0;             ///< [m], wall
  std::optional<double> upper;  ///< [m], wall; none: the track is open above
  double restitution_lower = 1, restitution_upper = 1;
  double friction = 0;  ///< [N], set-valued at rest
  double position = 0;  ///< [m], at the start, between the walls
  double velocity = 0;  ///< [m/s], at the start
  double duration = 1;  ///< [s]
  double slowest = 0;   ///< [m/s]; slower impacts are not scored
  std::vector<ForceSegment> force;
};
RICOCHET_JSON(TestScene, version, scene, kind, difficulty, mass, lower, upper, restitution_lower,
              restitution_upper, friction, position, velocity, duration, slowest, force);

/// The grades of a kind of scene.
inline constexpr int difficulties = 4;

/// The motion of a scene of ricochet of fidelity impact: walls,
/// restitution, friction, start, window and forces are those of `machine`, which has no contact
/// friction. Its speed may be a profile. Name, kind and
/// difficulty are left empty; `slowest` is the counting limit.
TestScene test_scene(const Scene& machine);

/// The applied force [N] at a time [s].
double force_at(const TestScene& scene, double time);

}  // namespace ricochet::studies::impact_test
