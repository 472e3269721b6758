#include "problems/carrier_track/regimes/basins.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/regimes/followed_motion.h"
#include "problems/carrier_track/regimes/steady_motion.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "ricochet/error.h"
#include "ricochet/machine.h"
#include "ricochet/random.h"
#include "src/core/in_parallel.h"

namespace ricochet::carrier_track::inline regimes {

namespace {

constexpr double same_number = 1e-6;  // relative
constexpr int most_starts = 10'000'000;

/// What two starts of one motion have in common.
struct SettledStart {
  LongRun motion;
  int turns;

  bool is_like(const SettledStart& other) const {
    const auto same = [](double a, double b) {
      return std::abs(a - b) <= same_number * std::max(std::abs(a), std::abs(b));
    };
    if (turns == 0 || other.turns == 0) return turns == other.turns;
    return turns == other.turns &&
           same(motion.collisions_per_turn, other.motion.collisions_per_turn) &&
           same(motion.energy_per_turn, other.motion.energy_per_turn) &&
           same(motion.fastest_impact, other.motion.fastest_impact) &&
           same(motion.share_at_rest, other.motion.share_at_rest);
  }
};

SettledStart settled_from(const Scene& start) {
  const SteadyMotion motion = steady_motion(start);
  return {long_run_of(motion), signature_of(motion).turns};
}

/// Throws InputError unless a number is > 0 and finite.
void check_positive(const char* name, double number, const char* unit) {
  if (number > 0 && std::isfinite(number)) return;
  throw InputError(fmt::format("{} {}: must be a finite number > 0 [{}]", name, number, unit));
}

void check_sampling(const Scene& scene, const BasinOptions& options) {
  check(scene, "scene");
  check_constant_speed(scene, "scene");
  check_regimes_exist(scene, "scene");
  if (!(scene.omega >= slowest_regime && scene.omega <= fastest_regime)) {
    throw InputError(fmt::format("scene: omega {}: must be within {}..{} [rad/s]", scene.omega,
                                 slowest_regime, fastest_regime));
  }
  if (forcing_turns(scene) == 0) {
    throw InputError(
        "scene: disturbance_frequency: must repeat with the driver plate within 16 turns: else no "
        "start settles on an orbit");
  }
  if (options.starts < 1 || options.starts > most_starts) {
    throw InputError(fmt::format("starts {}: must be within 1..{}", options.starts, most_starts));
  }
  if (options.height) check_positive("height", *options.height, "m");
  if (options.fastest) check_positive("fastest start", *options.fastest, "m/s");
  if (!options.height && !std::isfinite(scene.wall_upper)) {
    throw InputError("scene: wall_upper is inf: give the height of the highest start [m]");
  }
}

/// The machine at its speed, started at random within the limits of `basins`.
std::vector<Scene> random_starts(const Scene& scene, const Basins& basins, int count,
                                 Random& random) {
  const double period =
      2 * std::numbers::pi / scene.omega * static_cast<double>(forcing_turns(scene));
  std::vector<Scene> starts;
  starts.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    check_time_limit();
    Scene& start = starts.emplace_back(scene);
    const double time = period * uniform(random);
    constexpr double turn = 2 * std::numbers::pi;
    start.phase = std::remainder(scene.phase + scene.omega * time, turn);
    start.disturbance_phase =
        std::remainder(scene.disturbance_phase + scene.disturbance_frequency * time, turn);
    start.start_position = scene.wall_lower + basins.height * uniform(random);
    start.start_velocity = basins.fastest * (2 * uniform(random) - 1);
  }
  return starts;
}

/// Counts a start for the motion that it settled on.
void add(Basins& basins, const SettledStart& start) {
  ++basins.starts;
  const auto known = std::ranges::find_if(basins.basins, [&](const Basin& basin) {
    return start.is_like({basin.motion, basin.turns});
  });
  if (known == basins.basins.end()) {
    basins.basins.push_back({start.motion, start.turns, 1});
  } else {
    ++known->starts;
  }
}

}  // namespace

Basins basins_of(const Scene& scene, const BasinOptions& options) {
  Scene hard = scene;
  hard.fidelity = Fidelity::impact;
  check_sampling(hard, options);
  Basins result{};
  const double clearance = hard.wall_upper - hard.wall_lower;
  result.height = std::min(options.height.value_or(clearance), clearance);
  result.fastest = options.fastest.value_or(
      std::max({std::abs(hard.start_velocity), steady_motion(hard).fastest_impact(),
                result.height * hard.omega}));
  Random random(options.seed);
  constexpr int group = 1000;  // in memory at once
  bool in_time = true;
  for (int before = 0; before < options.starts && in_time; before += group) {
    std::vector<std::optional<SettledStart>> settled;
    try {
      const std::vector<Scene> starts =
          random_starts(hard, result, std::min(group, options.starts - before), random);
      settled.resize(starts.size());
      in_parallel(
          "starts", starts.size(), [&](std::size_t i) { settled[i] = settled_from(starts[i]); },
          static_cast<std::size_t>(before), static_cast<std::size_t>(options.starts));
    } catch (const TimeLimitReached&) {
      in_time = false;  // the starts before the first that had no time are taken
    }
    for (const std::optional<SettledStart>& start : settled) {
      if (!start) break;
      add(result, *start);
    }
  }
  if (result.starts == 0) throw TimeLimitReached();
  std::ranges::stable_sort(result.basins, std::greater{}, &Basin::starts);
  return result;
}

namespace {

constexpr double same_angle = 1e-6;  // [rad]
constexpr double same_speed = 1e-6;  // relative

/// The angle [rad] of the driver plate at an impact.
double angle_of(const Scene& scene, const Impact& impact) {
  return scene.phase + scene.omega * impact.time;
}

/// Whether the orbit has the same impact; `impact` is one of `scene`.
bool has(const SteadyMotion& motion, const Scene& scene, const Impact& impact) {
  return std::any_of(motion.impacts.begin(), motion.impacts.end(), [&](const Impact& known) {
    const double apart = angle_of(scene, impact) - angle_of(motion.orbit, known);
    return known.wall == impact.wall &&
           std::abs(std::remainder(apart, 2 * std::numbers::pi)) < same_angle &&
           std::abs(impact.speed / known.speed - 1) < same_speed;
  });
}

}  // namespace

std::optional<Anatomy> anatomy_of(const Scene& scene, const std::vector<Impact>& impacts) {
  if (!has_regimes(scene) || !(scene.omega > 0) || forcing_turns(scene) == 0) return std::nullopt;
  SteadyMotion motion;
  try {
    motion = steady_motion(scene);
  } catch (const std::runtime_error&) {  // more impacts than a simulation may have
    return std::nullopt;
  }
  if (!motion.settled) return std::nullopt;
  Anatomy anatomy;
  anatomy.per_turn = motion.collisions_per_turn();
  for (const Impact& impact : impacts) {
    const bool stays = has(motion, scene, impact);
    anatomy.in_the_long_run.push_back(stays);
    if (is_counted(impact.speed, scene.counting_limit)) {
      ++(stays ? anatomy.of_long_run : anatomy.of_start);
    }
  }
  return anatomy;
}

}  // namespace ricochet::carrier_track::inline regimes
