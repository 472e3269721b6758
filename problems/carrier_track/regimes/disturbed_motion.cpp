#include "problems/carrier_track/regimes/disturbed_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <iterator>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/motion/forces.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/regimes/border.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "src/core/time_limit.h"

namespace ricochet::carrier_track::inline regimes {

namespace {

constexpr double circle = 2 * std::numbers::pi;

/// Rebounds slower than this share of the counting limit are summed where the force hardly changes:
/// they are too slow for any margin above lowest_margin.
constexpr double summed_rebounds = 0.1;

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

/// The turn that a simulation has ended with.
DisturbedTurn turn_with(std::vector<Impact> impacts, double phase, double limit,
                        const End<double>& end) {
  DisturbedTurn turn{phase, std::move(impacts), {}, lowest_margin, 0, end.position, end.velocity};
  for (const Impact& impact : turn.impacts) {
    turn.margins.push_back(std::log(impact.speed / limit));
    if (is_counted(impact.speed, limit)) ++turn.collisions;
  }
  if (!turn.margins.empty()) turn.first = turn.margins.front();
  std::sort(turn.margins.begin(), turn.margins.end(), std::greater<>());
  return turn;
}

/// The last of `before` + 1 turns at each of these speeds and phases.
std::vector<DisturbedTurn> last_turns(const Scene& scene, std::span<const SpeedAndPhase> places,
                                      int before) {
  std::vector<LastTurn> last(places.size());
  Scene there = scene;
  there.window = Revolutions{static_cast<double>(before + 1)};
  const auto model_at = [&](std::size_t k) {
    const auto& [omega, phase] = places[k];
    const double start = before * circle / omega;
    there.phase = scene.phase;
    there.omega = omega;
    if (omega != scene.omega) begin_turns_at_rest(there);
    there.disturbance_phase = phase - start * scene.disturbance_frequency;
    last[k].start = start;
    last[k].slowest = std::exp(lowest_margin) * scene.counting_limit;
    return ImpactModel<double>(there, summed_rebounds * scene.counting_limit);
  };
  const auto outcomes =
      run_in_lanes(places.size(), model_at, [&](std::size_t k) -> LastTurn& { return last[k]; });
  std::vector<DisturbedTurn> turns;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (outcomes[k].failure) std::rethrow_exception(outcomes[k].failure);
    turns.push_back(turn_with(std::move(last[k].impacts), places[k].phase, scene.counting_limit,
                              outcomes[k].end));
  }
  return turns;
}

constexpr std::size_t even_phases = 64;
constexpr std::size_t even_phases_before = 128;  // where turns before have to erase the start
/// Numbers of turns whose rests erase the start, if it is not where turns start.
constexpr int erasing_turns[] = {2, 8, 32};
constexpr double same_end = 1e-6;     // of the clearance and of the counting limit
constexpr double same_margin = 1e-9;  // of turns that are the same
constexpr std::size_t most_phases = 2000;
constexpr double narrowest_gap = 1e-4;  // [rad]
constexpr double slow = -1.5;           // margins that are lower are alike
constexpr double near_limit = 1e-5;     // margins nearer to 0 are as near as this

/// Whether two turns of one phase, from different starts, are the same: their starts are forgotten.
bool are_same(const Scene& machine, const DisturbedTurn& a, const DisturbedTurn& b) {
  if (a.collisions != b.collisions) return false;
  // A carrier that friction holds in the gap remembers where, though nothing collides.
  const double away = std::abs(a.end_position - b.end_position);
  if (away > same_end * (machine.wall_upper - machine.wall_lower)) return false;
  const double faster = std::abs(a.end_velocity - b.end_velocity);
  if (faster > same_end * machine.counting_limit) return false;
  for (int rank = 1; rank <= a.collisions; ++rank) {
    if (std::abs(a.margin(rank) - b.margin(rank)) > same_margin) return false;
  }
  return true;
}

/// By how much margins that are not slow differ at `c` from the line through those at `a` and `b`,
/// which goes on by `ratio` of their distance.
double bend_between(const DisturbedTurn& a, const DisturbedTurn& b, const DisturbedTurn& c,
                    double ratio) {
  const auto bend = [ratio](double at_a, double at_b, double at_c) {
    const double x = std::max(at_a, slow), y = std::max(at_b, slow), z = std::max(at_c, slow);
    return std::abs(z - y - ratio * (y - x));
  };
  double largest = bend(a.first, b.first, c.first);
  const auto ranks = std::max({a.margins.size(), b.margins.size(), c.margins.size()});
  for (int rank = 1; rank <= static_cast<int>(ranks); ++rank) {
    largest = std::max(largest, bend(a.margin(rank), b.margin(rank), c.margin(rank)));
  }
  return largest;
}

/// Takes the fewest and the most collisions of some turns.
template <class Turn>
void take_extremes(DisturbedMotion& motion, const std::vector<Turn>& turns) {
  const auto [least, most] =
      std::minmax_element(turns.begin(), turns.end(),
                          [](const Turn& a, const Turn& b) { return a.collisions < b.collisions; });
  motion.least = least->collisions;
  motion.most = most->collisions;
}

/// Finds the turns of a motion, from a start at rest on a wall.
class Settling {
 public:
  explicit Settling(DisturbedMotion& motion) : motion_(motion), machine_(motion.machine) {}

  /// Whether turns depend on their phase alone, if they begin so many turns after that start.
  bool settles(double wall, int before, std::span<const double> also) {
    machine_.start_position = wall;
    motion_.turns_before = before;
    motion_.turns.clear();
    // Other phases at other speeds: turns that few phases have are met at one of them.
    const double shift = 20.6 * std::log(machine_.omega);
    std::vector<double> even;
    const std::size_t count = before == 0 ? even_phases : even_phases_before;
    for (std::size_t k = 0; k < count; ++k) {
      const double place = static_cast<double>(k) + shift - std::floor(shift);
      even.push_back(place / static_cast<double>(count) * circle);
    }
    // Half of them may tell that they do not.
    const std::span<const double> all = even;
    if (!forgets(all.first(count / 2)) || !forgets(all.last(count / 2)) || !forgets(also)) {
      return false;
    }
    for (;;) {
      sort();
      const std::vector<double> middles = middles_of_gaps();
      if (middles.empty()) return true;
      motion_.resolved = motion_.turns.size() + middles.size() <= most_phases;
      if (!motion_.resolved) return true;
      if (!forgets(middles)) return false;
    }
  }

  /// Takes the turns at some phases. False if the carrier does not return to where they begin.
  bool take(std::span<const double> phases) {
    std::vector<double> within(phases.begin(), phases.end());
    for (double& phase : within) phase -= circle * std::floor(phase / circle);
    std::vector<DisturbedTurn> turns = turns_at_phases(machine_, within, motion_.turns_before);
    const bool return_all = std::all_of(turns.begin(), turns.end(), [&](const auto& turn) {
      return turn.end_velocity == 0 && turn.end_position == machine_.start_position;
    });
    std::move(turns.begin(), turns.end(), std::back_inserter(motion_.turns));
    return motion_.turns_before > 0 || return_all;
  }

  void sort() {
    std::vector<DisturbedTurn>& turns = motion_.turns;
    std::sort(turns.begin(), turns.end(),
              [](const auto& a, const auto& b) { return a.phase < b.phase; });
    take_extremes(motion_, turns);
  }

 private:
  /// The same; false, too, if starts on both walls do not lead to the same.
  bool forgets(std::span<const double> phases) {
    const std::size_t first = motion_.turns.size();
    if (!take(phases)) return false;
    const int before = motion_.turns_before;
    if (before == 0 || !std::isfinite(machine_.wall_upper)) return true;
    Scene other = machine_;
    const bool on_lower = machine_.start_position == machine_.wall_lower;
    other.start_position = on_lower ? machine_.wall_upper : machine_.wall_lower;
    const auto others = turns_at_phases(other, phases, before);
    return std::equal(others.begin(), others.end(), motion_.turns.begin() + first,
                      [&](const auto& a, const auto& b) { return are_same(machine_, a, b); });
  }

  const DisturbedTurn& turn(std::size_t k) const { return motion_.turns[k % motion_.turns.size()]; }
  double gap_after(std::size_t k) const {
    return turn(k + 1).phase - turn(k).phase + ((k + 1) % motion_.turns.size() == 0 ? circle : 0);
  }

  /// How far margins of both turns are from other counts.
  double distance(const DisturbedTurn& a, const DisturbedTurn& b) const {
    const int more = motion_.most + 1;
    const double above = -std::max(a.margin(more), b.margin(more));
    const int fewer = motion_.least;
    const double below = fewer == 0 ? above : std::min(a.margin(fewer), b.margin(fewer));
    return std::max(near_limit, std::min(above, below));
  }

  /// The middles of the gaps between phases in which other turns may hide: margins bend there by
  /// more than they are away from other counts, or the count or the end of the turn jumps.
  std::vector<double> middles_of_gaps() const {
    const std::size_t count = motion_.turns.size();
    const double apart = (machine_.wall_upper - machine_.wall_lower) / 2;
    std::vector<double> middles;
    for (std::size_t k = count; k < 2 * count; ++k) {
      const double gap = gap_after(k);
      if (gap <= narrowest_gap) continue;
      // Beside a much narrower gap a jump is inside that.
      const auto ratio = [&](double beside) {
        return beside < gap / 2 ? 0 : std::min(1.0, gap / beside);
      };
      const auto &a = turn(k - 1), &b = turn(k), &c = turn(k + 1), &d = turn(k + 2);
      const double bend = std::max(bend_between(a, b, c, ratio(gap_after(k - 1))),
                                   bend_between(d, c, b, ratio(gap_after(k + 1))));
      const bool may_not_return =
          motion_.turns_before == 0 && std::abs(b.collisions - c.collisions) > 1;
      const bool jumps = may_not_return || std::abs(b.end_position - c.end_position) > apart;
      if (jumps || bend > distance(b, c)) middles.push_back(b.phase + gap / 2);
    }
    return middles;
  }

  DisturbedMotion& motion_;
  Scene& machine_;
};

}  // namespace

std::vector<DisturbedTurn> turns_at_phases(const Scene& scene, std::span<const double> phases,
                                           int before) {
  std::vector<SpeedAndPhase> places;
  for (const double phase : phases) places.push_back({scene.omega, phase});
  return last_turns(scene, places, before);
}

std::vector<DisturbedTurn> turns_of(const DisturbedMotion& motion,
                                    std::span<const SpeedAndPhase> places) {
  return last_turns(motion.machine, places, motion.turns_before);
}

const DisturbedTurn& extreme_turn(const DisturbedMotion& motion, int rank, Extreme extreme) {
  const auto lower = [rank](const auto& a, const auto& b) {
    return a.margin(rank) < b.margin(rank);
  };
  const auto& turns = motion.turns;
  return extreme == Extreme::least ? *std::min_element(turns.begin(), turns.end(), lower)
                                   : *std::max_element(turns.begin(), turns.end(), lower);
}

void begin_turns_at_rest(Scene& scene) {
  const auto plate = AppliedForces<double>(scene).flight(0, 0, 0).harmonic[0];
  scene.phase += std::numbers::pi / 2 - std::atan2(plate.sine, plate.cosine);
}

DisturbedMotion disturbed_motion(const Scene& scene, std::span<const double> also) {
  DisturbedMotion motion{scene};
  Scene& machine = motion.machine;
  begin_turns_at_rest(machine);
  machine.start_velocity = 0;
  const double lower = machine.wall_lower, upper = machine.wall_upper;
  const bool has_upper = std::isfinite(upper);
  const bool pressed_down = release_margin(machine, lower) <= release_margin(machine, upper);
  const double wall = pressed_down || !has_upper ? lower : upper;
  machine.start_position = wall;
  motion.moves = release_margin(machine, wall) > 0;
  if (!motion.moves) return motion;
  Settling settling(motion);
  if (has_upper && settling.settles(upper, 0, also)) return motion;
  if (settling.settles(lower, 0, also)) return motion;
  for (const int before : erasing_turns) {
    if (settling.settles(wall, before, also)) return motion;
  }
  motion.settled = false;
  motion.turns.clear();
  take_extremes(motion, irregular_turns(motion));
  return motion;
}

namespace {

/// What happens in the last turns of a window.
class LastTurns : public Observer {
 public:
  LastTurns(const Scene& scene, int before, int turns)
      : scene_(scene),
        turn_(circle / scene.omega),
        start_(turn_ * before),
        turns_(static_cast<std::size_t>(turns)) {}

  void impact(double time, Wall wall, double speed) {
    if (time < start_) return;
    const auto k = static_cast<std::size_t>((time - start_) / turn_);
    if (k >= turns_.size()) return;
    turns_[k].fastest = std::max(turns_[k].fastest, speed);
    turns_[k].energy += impact_loss(scene_, wall) * speed * speed;
    if (is_counted(speed, scene_.counting_limit)) ++turns_[k].collisions;
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

  const std::vector<ObservedTurn>& turns() const { return turns_; }

 private:
  const Scene& scene_;
  double turn_, start_;  // [s]
  std::vector<ObservedTurn> turns_;
};

constexpr int irregular_turn_count = 120;  // observed after as many
constexpr std::size_t mean_phases = 8;

std::vector<double> phases_from(double first, std::size_t count) {
  std::vector<double> phases;
  for (std::size_t k = 0; k < count; ++k) {
    phases.push_back(first + circle * static_cast<double>(k) / static_cast<double>(count));
  }
  return phases;
}

}  // namespace

std::vector<ObservedTurn> observed_turns(const Scene& scene, std::span<const double> phases,
                                         int before, int turns) {
  Scene there = scene;
  there.window = Revolutions{static_cast<double>(before + turns)};
  std::vector<LastTurns> last(phases.size(), LastTurns(scene, before, turns));
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
    all.insert(all.end(), last[k].turns().begin(), last[k].turns().end());
  }
  return all;
}

std::vector<ObservedTurn> irregular_turns(const DisturbedMotion& motion) {
  return observed_turns(motion.machine, std::span(&motion.machine.disturbance_phase, 1),
                        irregular_turn_count, irregular_turn_count);
}

LongRun long_run_of(const DisturbedMotion& motion) {
  if (!motion.moves) return {motion.machine, 0, 0, 0, 1};
  const std::vector<ObservedTurn> turns =
      motion.settled
          ? observed_turns(motion.machine, phases_from(0, mean_phases), motion.turns_before, 1)
          : irregular_turns(motion);
  LongRun result{motion.machine, 0, 0, 0, 0};
  const auto count = static_cast<double>(turns.size());
  for (const ObservedTurn& turn : turns) {
    result.collisions_per_turn += turn.collisions / count;
    result.energy_per_turn += turn.energy / count;
    result.share_at_rest += turn.share_at_rest / count;
    result.fastest_impact = std::max(result.fastest_impact, turn.fastest);
  }
  if (!motion.settled) return result;
  // Of all phases, each for those nearer to it than to others.
  result.collisions_per_turn = 0;
  double before = motion.turns.back().phase - circle;
  for (std::size_t k = 0; k < motion.turns.size(); ++k) {
    const DisturbedTurn& turn = motion.turns[k];
    const bool is_last = k + 1 == motion.turns.size();
    const double after = is_last ? motion.turns.front().phase + circle : motion.turns[k + 1].phase;
    result.collisions_per_turn += turn.collisions * (after - before) / (2 * circle);
    before = turn.phase;
    const double fastest = std::exp(turn.margin(1)) * motion.machine.counting_limit;
    if (!turn.margins.empty()) result.fastest_impact = std::max(result.fastest_impact, fastest);
  }
  return result;
}

namespace {

constexpr int sampled_speeds = 24;

SampledTurns sampled_at(const Scene& machine, double omega) {
  Scene scene = at_speed(machine, omega);
  scene.fidelity = Fidelity::impact;
  begin_turns_at_rest(scene);
  const auto phases =
      phases_from(scene.disturbance_phase, is_disturbed(scene) ? sampled_phases : 1);
  SampledTurns result{omega, 0, 0};
  const auto turns = observed_turns(scene, phases, sampled_turns_each, sampled_turns_each);
  for (const ObservedTurn& turn : turns) {
    result.mean_per_turn += turn.collisions;
    result.most_per_turn = std::max(result.most_per_turn, turn.collisions);
  }
  result.mean_per_turn /= static_cast<double>(turns.size());
  return result;
}

}  // namespace

std::vector<SampledTurns> sampled_turns(const Scene& scene, double from, double to) {
  std::vector<SampledTurns> sampled;
  try {
    // A turn at a slow speed takes longest.
    for (int k = sampled_speeds - 1; k >= 0; --k) {
      report_progress("simulations at single speeds", 1 - (k + 1.0) / sampled_speeds);
      const double omega =
          k == sampled_speeds - 1 ? to : from * std::pow(to / from, k / (sampled_speeds - 1.0));
      sampled.push_back(sampled_at(scene, omega));
    }
  } catch (const TimeLimitReached&) {
    // The speeds that had time are returned.
  } catch (const std::runtime_error&) {
    // More impacts than a simulation may have: at slower speeds, turns have even more.
  }
  std::reverse(sampled.begin(), sampled.end());
  return sampled;
}

}  // namespace ricochet::carrier_track::inline regimes
