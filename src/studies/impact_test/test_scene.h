#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ricochet/machine.h"
#include "ricochet/random.h"
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
RICOCHET_FIELDS(ForceTerm, amplitude, phase);

/// The force from a time on, until the next segment: the sum of its terms.
struct ForceSegment {
  double from;  ///< [s]
  std::vector<ForceTerm> terms;
};
RICOCHET_FIELDS(ForceSegment, from, terms);

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
RICOCHET_FIELDS(TestScene, version, scene, kind, difficulty, mass, lower, upper, restitution_lower,
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

/// What a tool may choose steps and tolerances by: it is sent with the scene.
struct Scales {
  double length = 0;  ///< [m], the clearance; without an upper wall the start's height, or 1 mm
  double force = 0;   ///< [N], no applied force is larger
  double speed = 0;   ///< [m/s], that the force gives over that length, or that of the start
  double step = 0;    ///< [s], twenty in the shortest period, and fifty in the duration
};
RICOCHET_FIELDS(Scales, length, force, speed, step);

Scales scales_of(const TestScene& scene);

/// How a tool's simulation of a scene ended.
enum class Ending {
  answered,
  cannot,  ///< the tool says that it cannot express the scene
  error,   ///< it failed: an error, a crash, or an answer that is none
  never    ///< no answer within the time limit
};

/// What a tool says of a scene.
struct Answer {
  std::string scene;  ///< its name
  Ending ending = Ending::answered;
  std::string reason = {};                          ///< of another ending than answered
  std::vector<carrier_track::Impact> impacts = {};  ///< in order of time
  double seconds = 0;                               ///< [s], time that the simulation took
  double deepest = 0;                               ///< [m], deepest penetration of a wall
};

/// The answer in a line that a tool has written for this scene. A line that is no answer is an
/// error, whose reason says why. A tool may list impacts in any order, and of any speed.
Answer answer_in(std::string_view line, const std::string& scene);

/// A line as a tool writes it, but for `never`, which has a key of its own.
std::string line_of(const Answer& answer);

/// An impact as it truly happens, to 1e-12 s, and how well it is conditioned.
struct TrueImpact {
  double time;  ///< [s]
  Wall wall;
  double speed;  ///< [m/s], of approach
  /// By how much the time [s] and the speed [m/s] change with a relative change of all numbers of
  /// the scene, divided by that change: the largest of a few changes of random signs.
  double time_sensitivity, speed_sensitivity;
};

/// The true impacts of a scene, faster than half of `slowest`, in order of time: those up to
/// `slowest` are not scored, but a tool may have them a little faster.
using Truth = std::vector<TrueImpact>;

/// Simulates in 80-bit numbers (oracle.h) and returns all impacts faster than half of `slowest`
/// [m/s]; without sensitivities. Nothing if the oracle gives up.
std::optional<std::vector<carrier_track::Impact>> exact_impacts(const TestScene& scene);

/// The same with sensitivities, up to the end of the scene or to where the scene stops being well
/// conditioned: before the first impact that appears, vanishes or changes its place in the order
/// when the numbers change by 1e-10, or whose time moves by more than `most_growth` mean times
/// between impacts per relative change. Nothing if the oracle gives up.
struct Conditioned {
  Truth impacts;
  double good_until;  ///< [s]
};
std::optional<Conditioned> conditioned_truth(const TestScene& scene, Random& random);

/// A relative change of 1e-5 then moves an impact by 1 % of the mean time between impacts at most.
inline constexpr double most_growth = 1e3;

/// The mean time between the scored impacts [s].
double mean_time_between(const TestScene& scene, const Truth& truth);

/// The number of impacts faster than `slowest`.
int scored_impacts(const TestScene& scene, const Truth& truth);

}  // namespace ricochet::studies::impact_test
