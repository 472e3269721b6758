#include "problems/carrier_track/regimes/disturbed_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <functional>
#include <iterator>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/motion/forces.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/regimes/border.h"
#include "problems/carrier_track/regimes/followed_motion.h"
#include "problems/carrier_track/regimes/sampled_turns.h"
#include "problems/carrier_track/regimes/steady_motion.h"
#include "problems/carrier_track/scene/scene_values.h"

namespace ricochet::carrier_track::inline regimes {

namespace {

constexpr double full_circle = 2 * std::numbers::pi;
constexpr int phases = 48;  // with 32, turns that few of the phases have stayed unseen
constexpr double next_phase = 0.6180339887498949 * full_circle / phases;  // from speed to speed
// Whose rests erase the start, if it is not where turns start: at least and at most.
constexpr std::array erasing_turns = {2, 8, 32};
constexpr double same_end = 1e-6;     // of the clearance and of the counting limit
constexpr int irregular_turns = 120;  // observed where they do not, after as many

/// All phases, evenly spaced.
std::vector<double> even_phases(double first) {
  std::vector<double> even;
  for (int k = 0; k < phases; ++k) even.push_back(first + full_circle * k / phases);
  return even;
}

/// Whether two turns of one phase, from different starts, are the same: their starts are forgotten.
bool are_same(const Scene& machine, const DisturbedTurn& a, const DisturbedTurn& b) {
  if (a.collisions != b.collisions) return false;
  // A carrier that friction holds in the gap remembers where, though nothing collides.
  const double away = std::abs(a.end_position - b.end_position);
  if (away > same_end * (machine.wall_upper - machine.wall_lower)) return false;
  const double faster = std::abs(a.end_velocity - b.end_velocity);
  if (faster > same_end * machine.counting_limit) return false;
  for (std::size_t i = 0; i < static_cast<std::size_t>(a.collisions); ++i) {
    if (std::abs(a.speeds[i] / b.speeds[i] - 1) > 1e-9) return false;
  }
  return true;
}

/// Takes the turns of some phases. Returns whether starts on either wall lead to the same.
bool take_if_forgotten(DisturbedMotion& motion, std::span<const double> some) {
  const Scene& machine = motion.machine;
  std::vector<DisturbedTurn> turns = turns_at_phases(machine, some, motion.turns_before);
  if (std::isfinite(machine.wall_upper)) {
    Scene other = machine;
    const bool on_lower = machine.start_position == machine.wall_lower;
    other.start_position = on_lower ? machine.wall_upper : machine.wall_lower;
    const auto others = turns_at_phases(other, some, motion.turns_before);
    for (std::size_t k = 0; k < turns.size(); ++k) {
      if (!are_same(machine, turns[k], others[k])) return false;
    }
  }
  std::move(turns.begin(), turns.end(), std::back_inserter(motion.turns));
  return true;
}

/// Takes the turns of all phases from a start at rest on that wall. Returns whether all end there.
bool all_return(DisturbedMotion& motion, double wall) {
  if (!std::isfinite(wall)) return false;
  motion.machine.start_position = wall;
  motion.turns_before = 0;
  motion.turns.clear();
  const std::vector<double> even = even_phases(motion.first_phase);
  // Half of them may tell that some do not.
  for (const auto& part : {std::span(even).first(phases / 2), std::span(even).last(phases / 2)}) {
    for (DisturbedTurn& turn : turns_at_phases(motion.machine, part, 0)) {
      if (!turn.returns) return false;
      motion.turns.push_back(std::move(turn));
    }
  }
  return true;
}

/// The turns that are observed of a motion that does not settle.
std::vector<ObservedTurn> irregular_turns_of(const Scene& machine) {
  return observed_turns(machine, std::span(&machine.disturbance_phase, 1), irregular_turns,
                        irregular_turns);
}

/// Takes the turns after some that erase the start on that wall.
void take_erased_turns(DisturbedMotion& motion, double wall) {
  motion.machine.start_position = wall;
  // Some phases may tell that the start is remembered.
  const std::vector<double> even = even_phases(motion.first_phase);
  std::vector<double> some;
  std::vector<double> rest;
  for (std::size_t k = 0; k < even.size(); ++k) (k % 6 == 0 ? some : rest).push_back(even[k]);
  for (const int before : erasing_turns) {
    motion.turns_before = before;
    motion.turns.clear();
    motion.settled = take_if_forgotten(motion, some) && take_if_forgotten(motion, rest);
    if (motion.settled) break;
  }
  if (!motion.settled) motion.turns.clear();
  std::sort(motion.turns.begin(), motion.turns.end(),
            [](const auto& a, const auto& b) { return a.phase < b.phase; });
}

/// Takes the turns of a motion that moves and is pressed to that wall.
void take_turns(DisturbedMotion& motion, double wall) {
  if (all_return(motion, motion.machine.wall_upper)) return;
  if (all_return(motion, motion.machine.wall_lower)) return;
  take_erased_turns(motion, wall);
}

/// The same of a motion that changes little from `before`: what was the case there is tried first.
void take_turns_as(DisturbedMotion& motion, double wall, const DisturbedMotion& before) {
  if (!before.moves || !before.settled) return take_turns(motion, wall);
  if (before.turns_before == 0) {
    if (!all_return(motion, before.machine.start_position)) take_turns(motion, wall);
    return;
  }
  take_erased_turns(motion, wall);
  if (!motion.settled) return;
  const std::optional<Wall> rest = motion.turns.front().rests_on;
  const bool returns = rest && std::all_of(motion.turns.begin(), motion.turns.end(),
                                           [&](const auto& turn) { return turn.rests_on == rest; });
  if (!returns) return;
  const Scene& machine = motion.machine;
  DisturbedMotion returning = motion;
  if (all_return(returning, rest == Wall::lower ? machine.wall_lower : machine.wall_upper)) {
    motion = std::move(returning);
  }
}

/// Takes the least and the most collisions of the turns.
void take_extremes(DisturbedMotion& motion) {
  const auto [least, most] =
      std::minmax_element(motion.turns.begin(), motion.turns.end(),
                          [](const auto& a, const auto& b) { return a.collisions < b.collisions; });
  motion.least = least->collisions;
  motion.most = most->collisions;
}

/// Lets a motion watch a turn.
void watch(DisturbedMotion& motion, DisturbedTurn turn) {
  motion.least = std::min(motion.least, turn.collisions);
  motion.most = std::max(motion.most, turn.collisions);
  motion.watched.push_back(std::move(turn));
  motion.known.clear();
}

/// Watches the phases that a motion before has watched, and those at which it had its fewest and
/// its most collisions, as long as no even phase tells of the same.
void watch_as(DisturbedMotion& motion, const DisturbedMotion& before) {
  if (!before.moves || !before.settled) return;
  std::vector<double> there;
  const auto look_at = [&](double phase) { there.push_back(phase_in(motion, before, phase)); };
  for (const DisturbedTurn& watched : before.watched) look_at(watched.phase);
  look_at(sampled_margin(before, before.least, Extreme::least).phase);
  look_at(sampled_margin(before, before.most, Extreme::most).phase);
  const int least = motion.least;
  const int most = motion.most;
  for (DisturbedTurn& watched : turns_at_phases(motion.machine, there, motion.turns_before)) {
    if (watched.collisions >= least && watched.collisions <= most) continue;
    watch(motion, std::move(watched));
  }
}

/// The motion of a scene, which is like one `before`, if that is given.
DisturbedMotion motion_like(const Scene& scene, const DisturbedMotion* before) {
  DisturbedMotion motion{scene};
  // Other phases at every speed: turns that few phases have are met at one of them.
  if (before != nullptr) {
    motion.first_phase = std::fmod(before->first_phase + next_phase, full_circle / phases);
  }
  Scene& machine = motion.machine;
  begin_turns_at_rest(machine);
  const bool pressed_down =
      release_margin(machine, machine.wall_lower) <= release_margin(machine, machine.wall_upper);
  const double wall =
      pressed_down || !std::isfinite(machine.wall_upper) ? machine.wall_lower : machine.wall_upper;
  machine.start_position = wall;
  machine.start_velocity = 0;
  if (release_margin(machine, wall) <= 0) {
    motion.moves = false;
    motion.turns = {{0, {}, {}, 0, wall, 0, true}};
    return motion;
  }
  before != nullptr ? take_turns_as(motion, wall, *before) : take_turns(motion, wall);
  if (!motion.settled) return motion;
  take_extremes(motion);
  if (before != nullptr) watch_as(motion, *before);
  for (DisturbedTurn& turn : rare_turns(motion)) watch(motion, std::move(turn));
  // Between the phases there may be turns with fewer and with more.
  while (motion.least > 0 && !(extreme_margin(motion, motion.least, Extreme::least).value > 0)) {
    --motion.least;
  }
  while (extreme_margin(motion, motion.most + 1, Extreme::most).value > 0) ++motion.most;
  return motion;
}

}  // namespace

void begin_turns_at_rest(Scene& scene) {
  const auto plate = AppliedForces<double>(scene).flight(0, 0, 0).harmonic[0];
  scene.phase += std::numbers::pi / 2 - std::atan2(plate.sine, plate.cosine);
}

DisturbedTurn turn_at(const DisturbedMotion& motion, double phase) {
  return turns_at_phases(motion.machine, std::span(&phase, 1), motion.turns_before).front();
}

Scene machine_at(const DisturbedMotion& motion, double omega, double phase) {
  Scene machine = at_speed(motion.machine, omega);
  begin_turns_at_rest(machine);
  machine.disturbance_phase = phase;
  return machine;
}

double phase_in(const DisturbedMotion& motion, const DisturbedMotion& other, double phase) {
  const double turn = full_circle * motion.machine.disturbance_frequency / motion.omega();
  return phase + turn * (other.turns_before - motion.turns_before);
}

void watch(DisturbedMotion& motion, double phase) {
  watch(motion, turn_at(motion, phase));
}

LongRun long_run_of(const DisturbedMotion& motion) {
  if (!motion.moves) return {motion.machine, 0, 0, 0, 1};
  std::vector<ObservedTurn> turns;
  if (!motion.settled) {
    turns = irregular_turns_of(motion.machine);
  } else {
    turns = observed_turns(motion.machine, even_phases(motion.first_phase), motion.turns_before, 1);
  }
  LongRun result{motion.machine, 0, 0, 0, 0};
  const auto count = static_cast<double>(turns.size());
  for (const ObservedTurn& observed : turns) {
    result.collisions_per_turn += observed.turn.collisions / count;
    result.energy_per_turn += observed.energy / count;
    result.share_at_rest += observed.share_at_rest / count;
    if (!observed.turn.speeds.empty()) {
      result.fastest_impact = std::max(result.fastest_impact, observed.turn.speeds.front());
    }
  }
  return result;
}

void observe(DisturbedMotion& motion) {
  if (motion.settled || !motion.turns.empty()) return;
  for (ObservedTurn& observed : irregular_turns_of(motion.machine)) {
    motion.turns.push_back(std::move(observed.turn));
  }
  take_extremes(motion);
}

DisturbedMotion disturbed_motion(const Scene& scene) {
  return motion_like(scene, nullptr);
}

DisturbedMotion followed(const DisturbedMotion& motion, double omega) {
  return motion_like(at_speed(motion.machine, omega), &motion);
}

namespace {

/// Rebounds slower than this share of the counting limit are summed: they are too slow for any
/// margin above lowest_margin.
constexpr double summed_rebounds = 1e-3;

/// Takes the impacts of the last turn.
struct LastTurn : Observer {
  static constexpr bool hears_impacts_alone = true;

  double start = 0;    // [s]
  double slowest = 0;  // [m/s]
  std::vector<Impact> impacts;

  void impact(double time, Wall wall, double speed) {
    if (time >= start && speed > slowest) impacts.push_back({time, wall, speed});
  }
};

}  // namespace

std::vector<DisturbedTurn> turns_at_phases(const Scene& scene, std::span<const double> phases,
                                           int before) {
  std::vector<Scene> scenes(phases.size(), scene);
  for (std::size_t k = 0; k < phases.size(); ++k) scenes[k].disturbance_phase = phases[k];
  return turns_of(scenes, before);
}

std::vector<DisturbedTurn> turns_of(std::span<const Scene> scenes, int before) {
  std::vector<LastTurn> last(scenes.size());
  const auto model_at = [&](std::size_t k) {
    Scene there = scenes[k];
    there.window = Revolutions{static_cast<double>(before + 1)};
    last[k].start = before * 2 * std::numbers::pi / there.omega;
    last[k].slowest = std::exp(lowest_margin) * there.counting_limit;
    return ImpactModel<double>(there, summed_rebounds * there.counting_limit);
  };
  std::vector<LaneOutcome> outcomes;
  if (scenes.size() == 1) {
    ImpactModel<double> model = model_at(0);
    outcomes.push_back({model.run(last[0]), nullptr});
  } else {
    outcomes =
        run_in_lanes(scenes.size(), model_at, [&](std::size_t k) -> LastTurn& { return last[k]; });
  }
  std::vector<DisturbedTurn> turns;
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    if (outcomes[k].failure) std::rethrow_exception(outcomes[k].failure);
    const Scene& scene = scenes[k];
    const End<double>& end = outcomes[k].end;
    DisturbedTurn turn{scene.disturbance_phase,
                       std::move(last[k].impacts),
                       {},
                       0,
                       end.position,
                       end.velocity,
                       false};
    if (end.velocity == 0) {
      turn.returns = end.position == scene.start_position;
      if (end.position == scene.wall_lower) turn.rests_on = Wall::lower;
      if (end.position == scene.wall_upper) turn.rests_on = Wall::upper;
    }
    for (const Impact& impact : turn.impacts) {
      turn.speeds.push_back(impact.speed);
      if (is_counted(impact.speed, scene.counting_limit)) ++turn.collisions;
    }
    std::sort(turn.speeds.begin(), turn.speeds.end(), std::greater<>());
    turns.push_back(std::move(turn));
  }
  return turns;
}

double margin_of(const Scene& scene, const DisturbedTurn& turn, int rank) {
  if (rank < 1 || rank > static_cast<int>(turn.speeds.size())) return lowest_margin;
  const double speed = turn.speeds[static_cast<std::size_t>(rank - 1)];
  return std::max(lowest_margin, std::log(speed / scene.counting_limit));
}

namespace {

/// What happens in the last turns of a window.
class LastTurns : public Observer {
 public:
  LastTurns(const Scene& scene, double phase, int before, int turns)
      : scene_(scene), turn_(2 * std::numbers::pi / scene.omega), start_(turn_ * before) {
    for (int k = 0; k < turns; ++k) turns_.push_back({{phase, {}, {}, 0}, 0, 0});
  }

  void impact(double time, Wall wall, double speed) {
    ObservedTurn* observed = at(time);
    if (observed == nullptr || speed <= 0) return;
    observed->turn.speeds.push_back(speed);
    observed->energy += impact_loss(scene_, wall) * speed * speed;
    if (is_counted(speed, scene_.counting_limit)) ++observed->turn.collisions;
  }

  template <class Path>
  void stretch(double time, const Path& path, double duration) {
    if (path.harmonics != 0) return;
    for (std::size_t k = 0; k < turns_.size(); ++k) {
      const double from = start_ + turn_ * static_cast<double>(k);
      const double within = std::min(time + duration, from + turn_) - std::max(time, from);
      if (within > 0) turns_[k].share_at_rest += within / turn_;
    }
  }

  std::vector<ObservedTurn> turns() {
    for (ObservedTurn& observed : turns_) {
      std::vector<double>& speeds = observed.turn.speeds;
      std::sort(speeds.begin(), speeds.end(), std::greater<>());
    }
    return turns_;
  }

 private:
  ObservedTurn* at(double time) {
    if (time < start_) return nullptr;
    const auto k = static_cast<std::size_t>((time - start_) / turn_);
    return k < turns_.size() ? &turns_[k] : nullptr;
  }

  const Scene& scene_;
  double turn_, start_;  // [s]
  std::vector<ObservedTurn> turns_;
};

}  // namespace

std::vector<ObservedTurn> observed_turns(const Scene& scene, std::span<const double> phases,
                                         int before, int turns) {
  Scene there = scene;
  there.window = Revolutions{static_cast<double>(before + turns)};
  std::vector<LastTurns> last;
  for (const double phase : phases) last.emplace_back(scene, phase, before, turns);
  const auto outcomes = run_in_lanes(
      phases.size(),
      [&](std::size_t k) {
        there.disturbance_phase = phases[k];
        return ImpactModel<double>(there);
      },
      [&](std::size_t k) -> LastTurns& { return last[k]; });
  std::vector<ObservedTurn> all;
  for (std::size_t k = 0; k < phases.size(); ++k) {
    if (outcomes[k].failure) std::rethrow_exception(outcomes[k].failure);
    for (ObservedTurn& observed : last[k].turns()) all.push_back(std::move(observed));
  }
  return all;
}

}  // namespace ricochet::carrier_track::inline regimes
