#include "problems/carrier_track/regimes/disturbed_motion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

#include "problems/carrier_track/regimes/border.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "src/core/time_limit.h"

namespace ricochet::carrier_track::inline regimes {

namespace {

constexpr double circle = 2 * std::numbers::pi;

std::vector<double> phases_from(double first, std::size_t count) {
  std::vector<double> phases;
  for (std::size_t k = 0; k < count; ++k) {
    phases.push_back(first + circle * static_cast<double>(k) / static_cast<double>(count));
  }
  return phases;
}

constexpr std::size_t few_phases = 8;  // that fill the lanes
// [rad], between phases of turns that are not alike, and that begin at rest on one wall, or not
constexpr double widest_gap = circle / 64, widest_moving_gap = circle / 128;
/// Numbers of turns whose rests erase the start, if it is not where turns start.
constexpr int erasing_turns[] = {2, 8, 32};
constexpr int recorded_turns = 20;    // of each of a few flights that have forgotten their starts
constexpr double same_start = 1e-9;   // of the clearance and of the counting limit
constexpr double same_end = 1e-6;     // of the same
constexpr double same_margin = 1e-9;  // of turns that are the same
constexpr std::size_t most_phases = 2000;
constexpr double narrowest_gap = 1e-4;  // [rad]
constexpr double slow = -1.5;           // margins that are lower are alike
constexpr double alike = 0.1;           // margins that differ by less over a few phases
constexpr double near_limit = 1e-5;     // margins nearer to 0 are as near as this

/// Whether two turns of one phase, from different starts, are the same: their starts are forgotten.
/// `room` is the height [m], and `limit` the speed [m/s], that their ends are compared with.
bool are_same(const DisturbedTurn& a, const DisturbedTurn& b, double room, double limit) {
  if (a.collisions != b.collisions) return false;
  // A carrier that friction holds in the gap remembers where, though nothing collides.
  if (std::abs(a.end_position - b.end_position) > same_end * room) return false;
  if (std::abs(a.end_velocity - b.end_velocity) > same_end * limit) return false;
  for (int rank = 1; rank <= a.collisions; ++rank) {
    if (std::abs(a.margin(rank) - b.margin(rank)) > same_margin) return false;
  }
  return true;
}

/// By how much `c` differs from the line through `a` and `b`, which goes on by `ratio` of their
/// distance.
double bend(double a, double b, double c, double ratio) {
  return std::abs(c - b - ratio * (b - a));
}

/// The largest bend of the margins that are not slow.
double margin_bend(const DisturbedTurn& a, const DisturbedTurn& b, const DisturbedTurn& c,
                   double ratio) {
  const auto at = [ratio](double x, double y, double z) {
    return bend(std::max(x, slow), std::max(y, slow), std::max(z, slow), ratio);
  };
  double largest = at(a.first, b.first, c.first);
  const auto ranks = std::max({a.margins.size(), b.margins.size(), c.margins.size()});
  for (int rank = 1; rank <= static_cast<int>(ranks); ++rank) {
    largest = std::max(largest, at(a.margin(rank), b.margin(rank), c.margin(rank)));
  }
  return largest;
}

/// That of the velocities [m/s] at which turns start and end: an impact that counts, and passes
/// from one turn to the next between two phases, changes them by more than the counting limit.
double velocity_bend(const DisturbedTurn& a, const DisturbedTurn& b, const DisturbedTurn& c,
                     double ratio) {
  return std::max(bend(a.start_velocity, b.start_velocity, c.start_velocity, ratio),
                  bend(a.end_velocity, b.end_velocity, c.end_velocity, ratio));
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
  Settling(DisturbedMotion& motion, std::span<const double> also)
      : motion_(motion), machine_(motion.machine), also_(also.begin(), also.end()) {
    // Other phases at other speeds: turns that few phases have are met at one of them.
    const double shift = 20.6 * std::log(machine_.omega);
    first_phase_ = widest_gap * (shift - std::floor(shift));
  }

  /// Whether every turn begins and ends at rest on a wall, where turns that begin otherwise lead,
  /// too.
  bool returns_to(double wall) {
    machine_.start_position = wall;
    motion_.turns.clear();
    if (!take(phases_from(first_phase_, few_phases))) return false;
    if (!is_reached() || !take(phases_from(first_phase_ + circle / 16, few_phases))) return false;
    sort();
    if (are_alike()) return true;
    std::vector<double> rest = also_;
    for (const double part : {1.0 / 64, 1.0 / 32, 3.0 / 64}) {
      const auto more = phases_from(first_phase_ + part * circle, 2 * few_phases);
      rest.insert(rest.end(), more.begin(), more.end());
    }
    return take(rest) && refine();
  }

  /// The same from turns that begin so on the wall of the last returns_to(): whether some turns
  /// later the start is forgotten.
  bool forgets() {
    choose_other_start();
    motion_.turns.clear();
    const std::vector<double> phases = phases_from(first_phase_, few_phases);
    std::vector<TurnStart> bodies = starts_at(phases, at_wall());
    const auto others = starts_at(phases, other_);
    bodies.insert(bodies.end(), others.begin(), others.end());
    int before = 0;
    for (;; ++before) {
      std::vector<DisturbedTurn> turns = flown_on(bodies);
      if (before >= erasing_turns[0] && are_pairs(turns)) {
        keep(turns, few_phases);
        break;
      }
      if (before == std::end(erasing_turns)[-1]) return false;
    }
    bodies.resize(few_phases);
    for (int k = 1; k < recorded_turns; ++k) {
      std::vector<DisturbedTurn> turns = flown_on(bodies);
      keep(turns, few_phases);
    }
    // Other phases may need more turns than these few.
    const int enough = std::min(2 * before, std::end(erasing_turns)[-1]);
    motion_.turns_before =
        *std::lower_bound(std::begin(erasing_turns), std::end(erasing_turns), enough);
    return take(also_) && refine();
  }

 private:
  TurnStart at_wall() const { return {machine_.omega, 0, machine_.start_position, 0}; }

  static std::vector<TurnStart> starts_at(std::span<const double> phases, TurnStart body) {
    std::vector<TurnStart> starts;
    for (const double phase : phases) {
      body.phase = phase - circle * std::floor(phase / circle);
      starts.push_back(body);
    }
    return starts;
  }

  /// Off the wall, as fast as the fastest impact.
  TurnStart knocked() const {
    double fastest = 0;
    for (const DisturbedTurn& turn : motion_.turns) fastest = std::max(fastest, turn.margin(1));
    const double speed = std::exp(fastest) * machine_.counting_limit;
    TurnStart start = at_wall();
    start.velocity = start.position == machine_.wall_lower ? speed : -speed;
    return start;
  }

  /// Another start: on the other wall; if there is none, at rest as high as turns end, or higher.
  void choose_other_start() {
    other_ = at_wall();
    room_ = machine_.wall_upper - machine_.wall_lower;
    if (std::isfinite(room_)) {
      other_.position =
          other_.position == machine_.wall_lower ? machine_.wall_upper : machine_.wall_lower;
      return;
    }
    // Friction may hold it there, though few turns, or none of these, lift it.
    room_ = knocked().velocity / machine_.omega;
    for (const DisturbedTurn& turn : motion_.turns) {
      room_ = std::max(room_, turn.end_position - machine_.wall_lower);
    }
    other_.position += room_;
  }

  /// The turns of some bodies, which move on to the next ones.
  std::vector<DisturbedTurn> flown_on(std::vector<TurnStart>& bodies) const {
    std::vector<DisturbedTurn> turns = turns_from(machine_, bodies);
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const double phase =
          bodies[k].phase + circle * machine_.disturbance_frequency / machine_.omega;
      bodies[k] = {machine_.omega, phase - circle * std::floor(phase / circle),
                   turns[k].end_position, turns[k].end_velocity};
    }
    return turns;
  }

  bool is_at_wall(double position, double velocity) const {
    return velocity == 0 && position == machine_.start_position;
  }

  /// Whether a carrier that is knocked off the wall where turns begin comes to rest there again.
  bool is_reached() const {
    std::vector<TurnStart> bodies = starts_at(phases_from(first_phase_, few_phases), knocked());
    for (int turn = 0; turn < std::end(erasing_turns)[-1]; ++turn) {
      flown_on(bodies);
      std::erase_if(bodies, [this](const TurnStart& body) {
        return is_at_wall(body.position, body.velocity);
      });
      if (bodies.empty()) return true;
    }
    return false;
  }

  /// Whether the second half of turns is the same as the first.
  bool are_pairs(const std::vector<DisturbedTurn>& turns) const {
    const auto half = static_cast<std::ptrdiff_t>(turns.size() / 2);
    return std::equal(turns.begin(), turns.begin() + half, turns.begin() + half,
                      [this](const auto& a, const auto& b) {
                        return are_same(a, b, room_, machine_.counting_limit);
                      });
  }

  /// Takes the first of some turns.
  void keep(std::vector<DisturbedTurn>& turns, std::size_t count) {
    std::move(turns.begin(), turns.begin() + static_cast<std::ptrdiff_t>(count),
              std::back_inserter(motion_.turns));
  }

  /// Takes turns that begin as they are known to. False if one does not end so, but all should.
  bool take_from(std::span<const TurnStart> starts) {
    std::vector<DisturbedTurn> turns = turns_from(machine_, starts);
    keep(turns, turns.size());
    return motion_.turns_before > 0 ||
           std::all_of(motion_.turns.end() - static_cast<std::ptrdiff_t>(starts.size()),
                       motion_.turns.end(), [this](const DisturbedTurn& turn) {
                         return is_at_wall(turn.end_position, turn.end_velocity);
                       });
  }

  /// Takes the turns at some phases. False if the carrier does not return to where they begin, or
  /// if no number of turns before makes it forget its start.
  bool take(const std::vector<double>& phases) {
    if (motion_.turns_before == 0) return take_from(starts_at(phases, at_wall()));
    for (;;) {
      std::vector<TurnStart> starts = starts_at(phases, at_wall());
      const auto others = starts_at(phases, other_);
      starts.insert(starts.end(), others.begin(), others.end());
      pass(machine_, starts, motion_.turns_before);
      const auto half = starts.begin() + static_cast<std::ptrdiff_t>(phases.size());
      const bool are_one = std::equal(starts.begin(), half, half, [this](auto& a, auto& b) {
        return std::abs(a.position - b.position) <= same_start * room_ &&
               std::abs(a.velocity - b.velocity) <= same_start * machine_.counting_limit;
      });
      if (are_one) return take_from({starts.begin(), half});
      std::vector<DisturbedTurn> turns = turns_from(machine_, starts);
      if (are_pairs(turns)) {
        keep(turns, phases.size());
        return true;
      }
      const auto more = std::upper_bound(std::begin(erasing_turns), std::end(erasing_turns),
                                         motion_.turns_before);
      if (more == std::end(erasing_turns)) return false;
      motion_.turns_before = *more;
    }
  }

  void sort() {
    std::vector<DisturbedTurn>& turns = motion_.turns;
    std::sort(turns.begin(), turns.end(),
              [](const auto& a, const auto& b) { return a.phase < b.phase; });
    take_extremes(motion_, turns);
  }

  /// Takes more turns, in the middles of gaps where they may hide.
  bool refine() {
    for (;;) {
      sort();
      std::vector<double> unknown;
      std::vector<KnownStart> known;
      for (const double middle : middles_of_gaps()) {
        if (const auto start = known_start(middle)) {
          known.push_back(*start);
        } else {
          unknown.push_back(middle);
        }
      }
      const std::size_t more = unknown.size() + known.size();
      if (more == 0) return true;
      motion_.resolved = motion_.turns.size() + more <= most_phases;
      if (!motion_.resolved) return true;
      if (!take_from(passed(std::move(known))) || !take(unknown)) return false;
    }
  }

  /// Where a carrier is known to be some turns before a turn.
  struct KnownStart {
    int before;
    TurnStart body;
  };

  /// The latest rest on a wall before the turn at a phase that both turns next to it have.
  std::optional<KnownStart> known_start(double phase) const {
    const std::vector<DisturbedTurn>& turns = motion_.turns;
    const double backwards = circle * machine_.disturbance_frequency / machine_.omega;
    for (int before = 0; before <= motion_.turns_before; ++before, phase -= backwards) {
      phase -= circle * std::floor(phase / circle);
      const auto next = std::upper_bound(
          turns.begin(), turns.end(), phase,
          [](double value, const DisturbedTurn& turn) { return value < turn.phase; });
      const DisturbedTurn& a = next == turns.begin() ? turns.back() : *std::prev(next);
      const DisturbedTurn& b = next == turns.end() ? turns.front() : *next;
      const double gap = b.phase - a.phase + (b.phase < a.phase ? circle : 0);
      if (gap < 1.001 * widest_gap && begin_on_one_wall(a, b)) {
        return KnownStart{before, {machine_.omega, phase, a.start_position, 0}};
      }
    }
    return std::nullopt;
  }

  bool begin_on_one_wall(const DisturbedTurn& a, const DisturbedTurn& b) const {
    const double wall = a.start_position;
    return a.start_velocity == 0 && b.start_velocity == 0 && b.start_position == wall &&
           (wall == machine_.wall_lower || wall == machine_.wall_upper);
  }

  /// The starts of the turns themselves.
  std::vector<TurnStart> passed(std::vector<KnownStart> starts) const {
    std::vector<TurnStart> bodies;
    // Those that have farther to go move on until all have as far: side by side.
    std::sort(starts.begin(), starts.end(),
              [](const auto& a, const auto& b) { return a.before > b.before; });
    for (std::size_t k = 0; k < starts.size(); ++k) {
      bodies.push_back(starts[k].body);
      const int left = k + 1 < starts.size() ? starts[k + 1].before : 0;
      for (int before = starts[k].before; before > left; --before) flown_on(bodies);
    }
    return bodies;
  }

  /// Whether turns have the same impacts, with margins that differ little and are far from other
  /// counts.
  bool are_alike() const {
    const std::vector<DisturbedTurn>& turns = motion_.turns;
    const std::size_t ranks = turns.front().margins.size();
    if (ranks == 0) return false;  // next to its release a carrier moves at few phases
    double spread = 0;
    for (const DisturbedTurn& turn : turns) {
      const auto same_wall = [](const Impact& a, const Impact& b) { return a.wall == b.wall; };
      const auto& impacts = turns.front().impacts;
      if (!std::equal(impacts.begin(), impacts.end(), turn.impacts.begin(), turn.impacts.end(),
                      same_wall))
        return false;
      for (std::size_t k = 0; k < ranks; ++k) {
        spread = std::max(spread, std::abs(turn.margins[k] - turns.front().margins[k]));
      }
      spread = std::max(spread, std::abs(turn.first - turns.front().first));
    }
    return spread < alike && 5 * spread < distance(turns.front(), turns.front());
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
      const auto &b = turn(k), &c = turn(k + 1);
      if (gap > 1.001 * (begin_on_one_wall(b, c) ? widest_gap : widest_moving_gap)) {
        middles.push_back(b.phase + gap / 2);
        continue;
      }
      // Beside a much narrower gap a jump is inside that.
      const auto ratio = [&](double beside) {
        return beside < gap / 2 ? 0 : std::min(1.0, gap / beside);
      };
      const auto &a = turn(k - 1), &d = turn(k + 2);
      const double before = ratio(gap_after(k - 1)), after = ratio(gap_after(k + 1));
      const double off = std::max(margin_bend(a, b, c, before), margin_bend(d, c, b, after));
      const double kick = std::max(velocity_bend(a, b, c, before), velocity_bend(d, c, b, after));
      const bool may_not_return =
          motion_.turns_before == 0 && std::abs(b.collisions - c.collisions) > 1;
      const bool jumps = may_not_return || std::abs(b.end_position - c.end_position) > apart ||
                         kick > machine_.counting_limit / 2;
      const double share = begin_on_one_wall(b, c) ? 1 : 0.5;
      if (jumps || off > share * distance(b, c)) middles.push_back(b.phase + gap / 2);
    }
    return middles;
  }

  DisturbedMotion& motion_;
  Scene& machine_;
  std::vector<double> also_;
  double first_phase_ = 0;
  TurnStart other_{};
  double room_ = 0;  // [m], that ends of turns are compared with
};

}  // namespace

std::vector<DisturbedTurn> turns_of(const DisturbedMotion& motion,
                                    std::span<const SpeedAndPhase> places) {
  std::vector<TurnStart> starts;
  for (const auto& [omega, phase] : places) {
    starts.push_back({omega, phase, motion.machine.start_position, 0});
  }
  pass(motion.machine, starts, motion.turns_before);
  return turns_from(motion.machine, starts);
}

const DisturbedTurn& extreme_turn(const DisturbedMotion& motion, int rank, Extreme extreme) {
  const auto lower = [rank](const auto& a, const auto& b) {
    return a.margin(rank) < b.margin(rank);
  };
  const auto& turns = motion.turns;
  return extreme == Extreme::least ? *std::min_element(turns.begin(), turns.end(), lower)
                                   : *std::max_element(turns.begin(), turns.end(), lower);
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
  Settling settling(motion, also);
  if (has_upper && settling.returns_to(wall == upper ? lower : upper)) return motion;
  if (settling.returns_to(wall) || settling.forgets()) return motion;
  motion.settled = false;
  motion.turns.clear();
  take_extremes(motion, irregular_turns(motion));
  return motion;
}

namespace {

constexpr int irregular_turn_count = 120;  // observed after as many
constexpr std::size_t mean_phases = 8;

}  // namespace

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
    if (!motion.settled) result.collisions_per_turn += turn.collisions / count;
    result.energy_per_turn += turn.energy / count;
    result.share_at_rest += turn.share_at_rest / count;
    result.fastest_impact = std::max(result.fastest_impact, turn.fastest);
  }
  if (!motion.settled) return result;
  // Of all phases, each for those nearer to it than to others.
  result.collisions_per_turn = motion.least;
  double before = motion.turns.back().phase - circle;
  for (std::size_t k = 0; k < motion.turns.size(); ++k) {
    const DisturbedTurn& turn = motion.turns[k];
    const bool is_last = k + 1 == motion.turns.size();
    const double after = is_last ? motion.turns.front().phase + circle : motion.turns[k + 1].phase;
    result.collisions_per_turn +=
        (turn.collisions - motion.least) * (after - before) / (2 * circle);
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
