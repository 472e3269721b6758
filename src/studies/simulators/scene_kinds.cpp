#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "problems/carrier_track/check/oracle.h"
#include "src/core/instance.h"
#include "src/studies/simulators/suite.h"

/// The kinds of scenes, and how one is drawn.
namespace ricochet::studies::simulators {

namespace {

using namespace carrier_track;

constexpr double half_turn = std::numbers::pi;

/// Draws of a scene's numbers.
class Draw {
 public:
  explicit Draw(Random& random) : random_(random) {}

  double within(double a, double b) { return a + (b - a) * uniform(random_); }
  /// 0 < a < b, uniform in the logarithm.
  double log_within(double a, double b) { return a * std::pow(b / a, within(0, 1)); }
  bool chance(double probability) { return within(0, 1) < probability; }

 private:
  Random& random_;
};

/// A scene as it is drawn. Its window may yet be cut, and its counting limit is set from its
/// impacts.
struct DrawnScene {
  Scene machine;
  double slowest_share = 1e-3;  ///< of the fastest impact: slower impacts are not scored
};

/// 10^-a at difficulty 1 to 10^-b at the highest, in steps; drawn within a step.
double closeness(Draw& draw, int difficulty, double a, double b) {
  const double step = (b - a) / 4;
  return std::pow(10, -draw.within(a + (difficulty - 1) * step, a + difficulty * step));
}

/// A body between walls under a steady pull, a turning force and, at times, a disturbance, all of
/// about the same size: ten or twenty impacts.
DrawnScene usual(Draw& draw) {
  Scene s;
  s.mass = draw.within(0.5, 2);
  const double gap = draw.log_within(0.5e-3, 5e-3);
  s.wall_lower = draw.chance(0.5) ? 0.0 : draw.within(-2e-3, 1e-3);
  s.wall_upper = s.wall_lower + gap;
  s.restitution_lower = draw.within(0.3, 0.8);
  s.restitution_upper = draw.chance(0.5) ? s.restitution_lower : draw.within(0.3, 0.8);
  const double force = s.mass * draw.log_within(0.5, 5);
  s.pull = force * draw.within(-1, 1);
  s.omega = draw.log_within(3, 20);
  s.phase = draw.within(-half_turn, half_turn);
  s.centrifugal_mass_radius = force * draw.within(0.5, 1.5) / (s.omega * s.omega);
  if (draw.chance(0.5)) {
    s.disturbance = force * draw.within(0.1, 0.6);
    s.disturbance_frequency = draw.log_within(5, 50);
    s.disturbance_phase = draw.within(-half_turn, half_turn);
  }
  if (draw.chance(0.3)) {
    s.friction = draw.within(0.05, 0.3);
    s.normal_force = force;
  }
  s.start_position = s.wall_lower + gap * draw.within(0.05, 0.95);
  s.start_velocity = draw.within(-1, 1) * std::sqrt(2 * force / s.mass * gap);
  s.window = Seconds{draw.within(1, 3) * 2 * half_turn / s.omega};
  return {s};
}

double gap_of(const Scene& s) {
  return s.wall_upper - s.wall_lower;
}

/// The same scene, with another gap; the start keeps its place in it.
void set_gap(Scene& s, double gap) {
  const double share = (s.start_position - s.wall_lower) / gap_of(s);
  s.wall_upper = s.wall_lower + gap;
  s.start_position = std::min(s.wall_lower + share * gap, s.wall_upper);
}

void set_restitution(Scene& s, double restitution) {
  s.restitution_lower = s.restitution_upper = restitution;
}

double force_of_plate(const Scene& s) {
  return s.centrifugal_mass_radius * s.omega * s.omega;
}

DrawnScene bouncing(Draw& draw, int difficulty) {
  DrawnScene drawn = usual(draw);
  auto& seconds = std::get<Seconds>(drawn.machine.window).count;
  seconds *= std::pow(2, difficulty - 1);
  return drawn;
}

DrawnScene chattering(Draw& draw, int difficulty) {
  DrawnScene drawn = usual(draw);
  Scene& s = drawn.machine;
  const double plate = force_of_plate(s);
  s.pull = plate * draw.within(0.3, 1.5);
  set_restitution(s, draw.within(0.4, 0.9));
  if (draw.chance(0.4)) s.wall_upper = std::numeric_limits<double>::infinity();
  drawn.slowest_share = closeness(draw, difficulty, 0.5, 3.5);
  return drawn;
}

/// The upper wall lies next to the highest summit of the path that it would not disturb.
DrawnScene grazing(Draw& draw, int difficulty) {
  for (;;) {
    DrawnScene drawn = usual(draw);
    Scene& s = drawn.machine;
    s.pull = std::abs(s.pull);
    const double gap = gap_of(s);
    s.wall_upper = std::numeric_limits<double>::infinity();
    const OracleRun run = oracle_run(s);
    const auto highest = std::ranges::max_element(run.summits, {}, &Summit::height);
    if (highest == run.summits.end() || highest->height < 0.1L * gap) continue;
    const double distance = closeness(draw, difficulty, 1, 7) * gap;
    const auto height = static_cast<double>(highest->height);
    s.wall_upper = s.wall_lower + height + (draw.chance(0.7) ? -distance : distance);
    if (s.wall_upper < s.start_position) continue;
    drawn.slowest_share = 1e-4;
    return drawn;
  }
}

DrawnScene sticking(Draw& draw, int difficulty) {
  DrawnScene drawn = usual(draw);
  Scene& s = drawn.machine;
  const double plate = force_of_plate(s);
  s.pull = plate * draw.within(-0.2, 0.2);
  s.disturbance *= 0.3;
  s.friction = 0.2;
  s.normal_force = plate * draw.within(0.4, 0.8) / s.friction;
  set_restitution(s, draw.within(0.0, 0.4));
  s.window = Seconds{std::pow(2, difficulty - 1) * draw.within(1, 2) * 2 * half_turn / s.omega};
  return drawn;
}

/// Friction just below the largest force: the body slides for a short while at its peak.
DrawnScene friction_limit(Draw& draw, int difficulty) {
  DrawnScene drawn = usual(draw);
  Scene& s = drawn.machine;
  s.pull = s.disturbance = 0;
  s.omega = draw.log_within(0.5, 5);
  const double plate = s.mass * draw.log_within(1, 5);
  s.centrifugal_mass_radius = plate / (s.omega * s.omega);
  const double close = closeness(draw, difficulty, 0.3, 2.3);
  s.friction = 0.3;
  s.normal_force = plate * (1 - close) / s.friction;
  // In one slide the body gets about so far.
  const double slide = 2 * plate / s.mass * close * close / (s.omega * s.omega);
  s.start_velocity = 0;
  set_gap(s, slide * draw.within(0.2, 3));
  s.window = Seconds{draw.within(2, 5) * 2 * half_turn / s.omega};
  drawn.slowest_share = 1e-2;
  return drawn;
}

DrawnScene near_simultaneous(Draw& draw, int difficulty) {
  DrawnScene drawn = usual(draw);
  Scene& s = drawn.machine;
  set_restitution(s, draw.within(0.6, 0.95));
  set_gap(s, gap_of(s) * closeness(draw, difficulty, 0, 3));
  drawn.slowest_share = 1e-2;
  return drawn;
}

DrawnScene slow_forcing(Draw& draw, int difficulty) {
  DrawnScene drawn = usual(draw);
  Scene& s = drawn.machine;
  const double plate = force_of_plate(s);
  s.pull = plate * draw.within(-0.5, 0.5);
  s.disturbance = 0;
  s.omega = closeness(draw, difficulty, 0, 1.7);
  s.centrifugal_mass_radius = plate / (s.omega * s.omega);
  s.window = Seconds{draw.within(0.7, 1.6) * 2 * half_turn / s.omega};
  drawn.slowest_share = 1e-2;
  return drawn;
}

DrawnScene fast_forcing(Draw& draw, int difficulty) {
  DrawnScene drawn = usual(draw);
  Scene& s = drawn.machine;
  s.disturbance = force_of_plate(s) * draw.within(0.5, 3);
  s.disturbance_frequency = 30 / closeness(draw, difficulty, 0, 2);
  s.disturbance_phase = draw.within(-half_turn, half_turn);
  return drawn;
}

DrawnScene elastic(Draw& draw, int difficulty) {
  DrawnScene drawn = usual(draw);
  Scene& s = drawn.machine;
  set_restitution(s, 1 - closeness(draw, difficulty, 1, 6));
  if (draw.chance(0.2)) set_restitution(s, 1);
  s.friction = s.normal_force = 0;
  return drawn;
}

DrawnScene plastic(Draw& draw, int difficulty) {
  DrawnScene drawn = usual(draw);
  set_restitution(drawn.machine, closeness(draw, difficulty, 0.5, 4));
  if (draw.chance(0.25)) set_restitution(drawn.machine, 0);
  return drawn;
}

DrawnScene profiles(Draw& draw, int difficulty) {
  DrawnScene drawn = usual(draw);
  Scene& s = drawn.machine;
  s.slider_mass_radius = s.centrifugal_mass_radius * draw.within(0, 0.3);
  s.pull_rotates = draw.chance(0.3);
  s.centrifugal = draw.chance(0.7)   ? Centrifugal::projected
                  : draw.chance(0.5) ? Centrifugal::inward
                                     : Centrifugal::outward;
  const double seconds = draw.within(2, 4) * 2 * half_turn / s.omega;
  const int knots = 1 << difficulty;
  double time = draw.chance(0.5) ? 0 : draw.within(0, 0.5) * seconds / knots;
  for (int k = 0; k < knots; ++k) {
    s.profile.push_back({time, s.omega * draw.within(0.3, 1.5)});
    time += seconds / knots * draw.within(0.5, 1.5);
  }
  s.window = Seconds{seconds};
  return drawn;
}

/// In the order of scene_kinds().
constexpr std::array draws = {bouncing,       chattering,        grazing,      sticking,
                              friction_limit, near_simultaneous, slow_forcing, fast_forcing,
                              elastic,        plastic,           profiles};

}  // namespace

const std::vector<SceneKind>& scene_kinds() {
  static const std::vector<SceneKind> kinds = {
      {"bouncing", "steady, turning and vibrating forces of the same size, restitution 0.3 to 0.8",
       "longer: 1, 2, 4, 8 times"},
      {"chattering", "rebounds on one wall that become ever smaller, restitution 0.4 to 0.9",
       "slower impacts are scored: from 1/3 to 1/3000 of the fastest"},
      {"grazing", "a wall next to the highest point of the free path, before it or behind it",
       "the distance: 1e-1 to 1e-7 of the clearance"},
      {"sticking", "friction of 0.4 to 0.8 of the turning force, restitution up to 0.4",
       "longer: 1, 2, 4, 8 times"},
      {"friction-limit",
       "friction just below the largest force: short slides, a clearance as short",
       "the friction: from 50 % to 0.5 % below the force"},
      {"near-simultaneous", "a clearance so narrow that impacts on both walls follow at once",
       "the clearance: 1 to 1e-3 of the usual one"},
      {"slow-forcing", "long rests on a wall, which the body leaves as the force changes its sign",
       "the force turns with 1 to 0.02 rad/s"},
      {"fast-forcing", "a vibration as strong as the other forces", "it has 30 to 3000 rad/s"},
      {"elastic", "without friction, restitution next to 1, or 1", "1 - restitution: 1e-1 to 1e-6"},
      {"plastic", "restitution next to 0, or 0", "the restitution: 0.3 to 1e-4"},
      {"profiles", "a driver plate whose speed changes linearly between knots",
       "2, 4, 8, 16 knots"},
  };
  return kinds;
}

namespace {

/// The latest time up to `good_until` [s] in a wide enough gap between impacts; nothing if there is
/// none after a scored impact.
std::optional<double> good_end(const TestScene& scene, const Conditioned& known) {
  Truth impacts = known.impacts;
  const double clear = clear_of_the_end * mean_time_between(scene, impacts);
  if (known.good_until == scene.duration && !impacts.empty() &&
      scene.duration - impacts.back().time >= clear) {
    if (scored_impacts(scene, impacts) <= most_impacts) return scene.duration;
  }
  double next = known.good_until;
  while (!impacts.empty()) {
    const double last = impacts.back().time;
    const int scored = scored_impacts(scene, impacts);
    if (scored == 0) break;
    if (scored <= most_impacts && next - last >= 2 * clear) return (last + next) / 2;
    next = last;
    impacts.pop_back();
  }
  return std::nullopt;
}

double fastest_of(const std::vector<Impact>& impacts) {
  double fastest = 0;
  for (const Impact& i : impacts) fastest = std::max(fastest, i.speed);
  return fastest;
}

double rounded_to_three_digits(double x) {
  const double unit = std::pow(10, std::floor(std::log10(x)) - 2);
  return std::round(x / unit) * unit;
}

/// The drawn scene with its truth and its counting limit; nothing if there is no truth.
std::optional<ScoredScene> scored_scene(DrawnScene drawn, Random& random) {
  Scene& machine = drawn.machine;
  machine.counting_limit = 2 * least_slowest;
  const auto all = exact_impacts(test_scene(machine));
  if (!all || all->empty()) return std::nullopt;
  machine.counting_limit =
      std::max(rounded_to_three_digits(drawn.slowest_share * fastest_of(*all)), least_slowest);
  const auto known = conditioned_truth(test_scene(machine), random);
  if (!known) return std::nullopt;
  const auto end = good_end(test_scene(machine), *known);
  if (!end) return std::nullopt;
  machine.window = Seconds{*end};
  ScoredScene scored{0, test_scene(machine), machine, known->impacts};
  std::erase_if(scored.truth, [&](const TrueImpact& i) { return i.time > *end; });
  return scored;
}

}  // namespace

ScoredScene drawn_scene(int seed, int index) {
  const auto kinds = static_cast<int>(scene_kinds().size());
  const auto k = static_cast<std::size_t>(index % kinds);
  const SceneKind& kind = scene_kinds()[k];
  const int difficulty = 1 + index / kinds % difficulties;
  // The study's former name: another would draw other scenes.
  Random random(seed_of("impact-test", kind.name, seed, index));
  Draw draw(random);
  for (;;) {
    const DrawnScene drawn = draws[k](draw, difficulty);
    auto scored = scored_scene(drawn, random);
    if (!scored) continue;
    scored->seed = seed;
    scored->scene.scene = fmt::format("{}-{:05}", kind.name, index);
    scored->scene.kind = kind.name;
    scored->scene.difficulty = difficulty;
    return std::move(*scored);
  }
}

}  // namespace ricochet::studies::simulators
