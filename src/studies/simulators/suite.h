#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "problems/carrier_track/check/integrator.h"
#include "ricochet/machine.h"
#include "ricochet/random.h"
#include "ricochet/scene.h"
#include "solvers/outside/line_solver.h"
#include "src/report/json.h"
#include "src/report/results.h"
#include "src/studies/simulators/study.h"

/// The scenes that simulators of impacts are measured by, with their true impacts; who simulates
/// them; and the scores.
namespace ricochet::studies::simulators {

using carrier_track::Impact;
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
/// x' -> -restitution x' at a wall. The format is that of docs/simulators.md.
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

/// The motion of a scene of ricochet of fidelity impact: walls, restitution, friction, start,
/// window and forces are those of `machine`, which has no contact friction. Its speed may be a
/// profile. Name, kind and difficulty are left empty; `slowest` is the counting limit.
TestScene test_scene(const Scene& machine);

/// What a tool may choose steps and tolerances by: it is sent with the scene.
struct Scales {
  double length = 0;  ///< [m], the clearance; without an upper wall the start's height, or 1 mm
  double force = 0;   ///< [N], no applied force is larger
  double speed = 0;   ///< [m/s], that the force gives over that length, or that of the start
  double step = 0;    ///< [s], twenty in the shortest period, and fifty in the duration
};
RICOCHET_FIELDS(Scales, length, force, speed, step);
Scales scales_of(const TestScene& scene);

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
std::optional<std::vector<Impact>> exact_impacts(const TestScene& scene);

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

/// A scene of the suite, with what it is scored by.
struct ScoredScene {
  int seed = 0;  ///< of the draw
  TestScene scene;
  Scene machine;  ///< the same for ricochet; its counting limit is the scene's `slowest`
  Truth truth;
};

/// A kind of scene. What gets closer, smaller or longer with the difficulty is its own.
struct SceneKind {
  std::string name;
  std::string what;    ///< in words
  std::string harder;  ///< what the difficulty changes, in words, with the range
};
inline constexpr int difficulties = 4;  ///< of each kind
const std::vector<SceneKind>& scene_kinds();

/// Scene `index` >= 0 of a seed; each can be drawn alone. Kinds alternate, and then difficulties.
/// A scene is drawn again until it has a truth and at least one scored impact. Its window ends in a
/// gap between impacts, before it is badly conditioned.
ScoredScene drawn_scene(int seed, int index);

/// No scored impact is slower [m/s]: tools may set a body to rest at 1e-6 m/s.
inline constexpr double least_slowest = 1e-5;

/// A window ends at least so far from an impact, in mean times between impacts.
inline constexpr double clear_of_the_end = 0.1;

/// A window ends after so many scored impacts.
inline constexpr int most_impacts = 200;

/// A line of scenes.jsonl: the scene as a tool reads it, then `impacts`, the truth, and `machine`,
/// the scene as a machine file.
report::Json json_of(const ScoredScene& scored);

/// The scene of a machine as it is, with its truth: its window and counting limit stay. Nothing if
/// it is not a valid machine, has no impact that counts, or is not well conditioned up to its end.
std::optional<ScoredScene> exactly(const Scene& machine);

/// A simpler scene that still breaks a tool, as found by dropping forces, friction and walls, by
/// cutting the window and rounding numbers, one step at a time, as long as `breaks` says that the
/// scene still does. Each step must leave a scene that is well conditioned up to its end. At most
/// `most_asks` scenes are tried.
ScoredScene smallest_scene(const ScoredScene& broken,
                           const std::function<bool(const ScoredScene&)>& breaks, int most_asks);

/// The machine in a line: the fields that are not at their default, with units.
std::string words_of(const Scene& machine);

/// How a simulation of a scene ended.
enum class Ending {
  answered,
  cannot,  ///< the simulator says that it cannot express the scene
  error,   ///< it failed: an error, a crash, or an answer that is none
  never    ///< no answer within the time limit
};

/// What a simulator says of a scene.
struct Answer {
  std::string scene;  ///< its name
  Ending ending = Ending::answered;
  std::string reason = {};           ///< of another ending than answered
  std::vector<Impact> impacts = {};  ///< in order of time
  double seconds = 0;                ///< [s], time that the simulation took
  double deepest = 0;                ///< [m], deepest penetration of a wall
};

/// The answer in a line that a tool has written for this scene. A line that is no answer is an
/// error, whose reason says why. A tool may list impacts in any order, and of any speed.
Answer answer_in(std::string_view line, const std::string& scene);

/// A line as a tool writes it, but for `never`, which has a key of its own.
std::string line_of(const Answer& answer);

/// An answer compared with the truth. An impact counts if it is faster than the scene's `slowest`.
/// A partner is at most half a mean time between impacts away, and needs only half that speed: so
/// an impact just above the limit that a tool finds just below it is neither missed nor, the other
/// way round, invented.
///
/// Without an answer all impacts are missed, except if the tool cannot express the scene: then
/// nothing is scored.
struct Score {
  Ending ending = Ending::answered;
  int impacts = 0;      ///< true ones that count
  int missed = 0;       ///< of them without a partner
  int invented = 0;     ///< impacts of the tool that count, without a partner
  int late = 0;         ///< partners apart by more than 1 % of the mean time between impacts
  int wrong_speed = 0;  ///< partners, not late, whose speeds differ by more than 1 %
  /// Largest difference in time between partners, in mean times between impacts; of all partners
  /// until the first impact that is missed or invented. Nothing without partners.
  std::optional<double> time_error = {};
  std::optional<double> penetration = {};         ///< deepest [m]
  std::optional<double> seconds_per_impact = {};  ///< [s], over the true impacts that count

  int wrong() const { return missed + invented; }
};
Score score_of(const Answer& answer, const ScoredScene& scored);

/// Scores added up. Per 1,000: of the true impacts in the scenes that the tool can express; those
/// of scenes without an answer are missed.
struct Tally {
  int scenes = 0, answered = 0, cannot = 0, errors = 0, never = 0;
  int impacts = 0, missed = 0, invented = 0, late = 0, wrong_speed = 0;
  std::optional<double> time_error;          ///< median over scenes, in mean times between impacts
  std::optional<double> penetration;         ///< [m], largest
  std::optional<double> seconds_per_impact;  ///< [s], median over scenes

  std::optional<double> per_thousand(int number) const;
  std::optional<double> wrong() const { return per_thousand(missed + invented); }
};
Tally tally_of(const std::vector<Score>& scores);

/// The median; nothing for an empty list.
std::optional<double> median_of(std::vector<double> values);

/// For each true impact the place of its partner in the other list, or nothing. Both lists are in
/// order of time. Partners are on the same wall and at most `apart` [s] away from each other; on a
/// wall they keep their order, and nobody has two. Of all such pairings this one has the most
/// pairs, and of those the smallest sum of differences in time.
std::vector<std::optional<std::size_t>> partners_of(const std::vector<Impact>& true_ones,
                                                    const std::vector<Impact>& found, double apart);

/// A tool that cannot be used at all. The message says why.
class ToolFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Asks for the answer to a scene. Throws ToolFailure if there will be none to any scene.
using Ask = std::function<Answer(const ScoredScene&)>;

/// Whatever is measured: a tool, a numerical method, or a level of ricochet's own model.
struct Simulator {
  Tool tool;  ///< of our own: what is said of it, and nothing to run
  std::string version;
  bool own = false;                ///< in this process
  std::function<Ask(Level)> open;  ///< for this thread alone
};

/// ricochet's hard walls, by which the others are measured, first; then the same in a scan over
/// speeds, hard walls in two directions, compliant walls, and the numerical methods of
/// integrator.h.
std::vector<Simulator> own_simulators();

/// A tool whose errors are written to files in the folder `logs`.
Simulator simulator_of(const FoundTool& tool, const std::filesystem::path& logs);

/// The scene for fidelity planar: the same motion, with half of the friction from a wall in y
/// against which the body is pressed, or, where other forces act in y, without walls there.
Scene planar_machine(const Scene& machine);

/// A hash of what a tool's driver is made of: its source, what drivers share (headers, `tool.*` and
/// `tool_*` beside it), and the command that compiles it.
std::string driver_hash(const Tool& tool);

/// How long a tool is waited for.
struct TimeLimits {
  std::chrono::seconds start{60};  ///< for the first answer of a process: Python imports
  std::chrono::seconds scene{5};
};

/// A tool that is asked scene by scene. It runs until it fails: then it is killed, and started
/// again with the next scene. Only the thread that made the session may use it.
class ToolSession {
 public:
  /// The tool's standard error is added to the file `log`.
  ToolSession(const FoundTool& tool, Level level, const std::filesystem::path& log,
              TimeLimits limits = {});

  /// The tool's answer to a scene, whatever happens to the tool. Throws ToolFailure if it has
  /// failed `most_failed_starts` times without ever answering.
  Answer ask(const TestScene& scene);

  static constexpr int most_failed_starts = 3;

 private:
  Answer answered(const TestScene& scene);
  Answer failed(const std::string& scene);

  std::vector<std::string> command_;
  std::filesystem::path log_;
  TimeLimits limits_;
  std::optional<outside::LineProgram> process_;
  bool has_answered_ = false;  // this process
  bool has_ever_answered_ = false;
  int failed_starts_ = 0;
};

/// The answers to some scenes, in their order. Those in the file are taken from there; the others
/// are asked for and added to it one by one, so that a run which is interrupted goes on there. A
/// file whose first line is not `origin` is replaced, and a last line that is cut off is asked
/// for again.
std::vector<Answer> kept_answers(const std::filesystem::path& file, const std::string& origin,
                                 std::span<const ScoredScene> scenes, const Ask& ask);

// The other questions of the study. Each adds its values, tables and charts.

/// What restitution does a contact law return? Every law, for 0.02, 0.03, ..., 0.98, by the closed
/// relation of damping and restitution; by simulation, too, for every `stride`-th of them.
void add_laws(report::Results& results, std::size_t stride);

/// What a contact law returns for a restitution `asked` in (0, 1): by the closed relation, and in a
/// simulated impact at 1 m/s without any other force.
double closed_return(carrier_track::ContactLaw law, double asked);
double simulated_return(carrier_track::ContactLaw law, double asked);

/// What model does a scene need? The paper's cases at speeds `step` [rad/s] apart up to 18, by hard
/// walls, compliant walls and both directions.
void add_models(report::Results& results, double step);

/// Where do methods fail on stiff walls? Methods that integrate through the contacts of compliant
/// walls, over stiffnesses and all tolerances or steps, `per_decade` of them each.
void add_stiff_walls(report::Results& results, int per_decade);

}  // namespace ricochet::studies::simulators
