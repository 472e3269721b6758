#include "problems/carrier_track/regimes/disturbed_motion.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

#include "problems/carrier_track/flight/applied_forces.h"
#include "problems/carrier_track/regimes/followed_motion.h"
#include "problems/carrier_track/regimes/observed_turn.h"
#include "problems/carrier_track/regimes/phase_window.h"
#include "problems/carrier_track/regimes/release_margin.h"
#include "problems/carrier_track/regimes/steady_motion.h"

namespace ricochet::carrier_track::inline regimes {
namespace {

constexpr double full_circle = 2 * std::numbers::pi;
constexpr int phases = 16;
constexpr int erasing_turns = 2;      // whose rests erase the start, if it is not where turns start
constexpr int irregular_turns = 120;  // observed where they do not, after as many
constexpr int phase_bits = 24;        // of an extreme phase: its margin has twice as many
constexpr double widest_window = 0.1;  // [rad], to each side, in which extremes are searched
constexpr double narrowest_window = 1e-4;
constexpr double jump = 1e-4;            // more than that, where an impact appears or vanishes
constexpr double smooth = 1e-11;         // relative, what a polynomial may leave out
constexpr double refined_within = 0.02;  // margins nearer to 0 are searched, not interpolated

/// Lets the turns of the plate begin where its force passes zero from above: a carrier that rests
/// in every half turn then rests.
void begin_turns_at_rest(Scene& scene) {
  const auto plate = AppliedForces<double>(scene).flight(0, 0, 0).harmonic[0];
  scene.phase += std::numbers::pi / 2 - std::atan2(plate.sine, plate.cosine);
}

/// Whether what happened before the erasing turns is forgotten: starts on either wall lead to the
/// same turn.
bool forgets(const DisturbedMotion& motion) {
  Scene machine = motion.machine;
  if (!std::isfinite(machine.wall_upper)) return true;
  const bool on_lower = machine.start_position == machine.wall_lower;
  machine.start_position = on_lower ? machine.wall_upper : machine.wall_lower;
  std::vector<double> some;
  for (std::size_t k = 0; k < motion.turns.size(); k += 5) some.push_back(motion.turns[k].phase);
  const std::vector<DisturbedTurn> turns = turns_at_phases(machine, some, motion.turns_before);
  for (std::size_t k = 0; k < turns.size(); ++k) {
    const DisturbedTurn& here = motion.turns[5 * k];
    if (turns[k].collisions != here.collisions) return false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(here.collisions); ++i) {
      if (std::abs(turns[k].speeds[i] / here.speeds[i] - 1) > 1e-9) return false;
    }
  }
  return true;
}

/// All phases, evenly spaced.
std::vector<double> even_phases() {
  std::vector<double> even;
  for (int k = 0; k < phases; ++k) even.push_back(full_circle * k / phases);
  return even;
}

/// Takes the turns of all phases from a start at rest on that wall. Returns whether all end there.
bool all_return(DisturbedMotion& motion, double wall) {
  if (!std::isfinite(wall)) return false;
  motion.machine.start_position = wall;
  motion.turns.clear();
  const std::vector<double> even = even_phases();
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

/// Takes the turns of a motion that moves.
void take_turns(DisturbedMotion& motion) {
  const Scene machine = motion.machine;
  if (all_return(motion, machine.wall_upper) || all_return(motion, machine.wall_lower)) return;
  motion.machine = machine;
  motion.turns_before = erasing_turns;
  motion.turns = turns_at_phases(machine, even_phases(), erasing_turns);
  motion.settled = forgets(motion);
  if (!motion.settled) motion.turns.clear();
}

/// Takes the least and the most collisions of the turns.
void take_extremes(DisturbedMotion& motion) {
  const auto [least, most] =
      std::minmax_element(motion.turns.begin(), motion.turns.end(),
                          [](const auto& a, const auto& b) { return a.collisions < b.collisions; });
  motion.least = least->collisions;
  motion.most = most->collisions;
}

/// The least value of the parabola through the values at -1, 0 and 1, of which that at 0 is the
/// least.
double vertex_of(double before, double here, double after) {
  const double bend = before - 2 * here + after;
  if (!(bend > 0)) return here;
  const double place = (before - after) / (2 * bend);
  return here - bend * place * place / 2;
}

/// The margins of an impact over the phases, with a sign that makes the extreme one the least.
class PhaseMargins {
 public:
  PhaseMargins(const DisturbedMotion& motion, int rank, Extreme extreme)
      : sign_(extreme == Extreme::most ? -1 : 1) {
    for (const DisturbedTurn& turn : motion.turns) {
      values_.push_back(sign_ * margin_of(motion.machine, turn, rank));
    }
    interpolates_ = motion.settled && values_.size() > 2;
  }

  double sign() const { return sign_; }
  double at(std::size_t k) const { return values_[k % values_.size()]; }
  std::size_t deepest() const {
    return static_cast<std::size_t>(std::min_element(values_.begin(), values_.end()) -
                                    values_.begin());
  }

  /// Phases lower than both neighbours, the deepest first.
  std::vector<std::size_t> valleys() const {
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < values_.size(); ++k) {
      if (at(k) <= at(k + values_.size() - 1) && at(k) <= at(k + 1)) found.push_back(k);
    }
    std::sort(found.begin(), found.end(),
              [&](std::size_t a, std::size_t b) { return at(a) < at(b); });
    return found;
  }

  /// The least, between the phases by parabolas.
  double least() const {
    double least = at(deepest());
    if (!interpolates_ || std::abs(least) >= -lowest_margin) return least;
    for (const std::size_t k : valleys()) {
      least = std::min(least, vertex_of(at(k + values_.size() - 1), at(k), at(k + 1)));
    }
    return least;
  }

 private:
  double sign_;
  bool interpolates_;
  std::vector<double> values_;
};

struct Valley {
  double phase, value;
};

/// The least margin, with that sign, near `phase`: within a step of the phases, or as far as it
/// goes down.
Valley least_near(const DisturbedMotion& motion, int rank, double sign, double phase) {
  Valley found{phase, std::numeric_limits<double>::infinity()};
  bool jumps = false;
  double centre = phase;
  double around = widest_window;
  for (int windows = 0; windows < 10 && around > narrowest_window; ++windows) {
    const PhaseWindow window(motion, rank, centre, around);
    if (!window.is_known()) break;
    jumps = jumps || window.error() > jump;
    const PhaseWindow::Valley valley = window.least(sign);
    centre = valley.phase;
    if (!valley.inside) continue;
    if (window.error() <= smooth) {
      found = {valley.phase, valley.value};
      break;
    }
    around /= 8;
  }
  if (std::isfinite(found.value) && !jumps) return found;
  const double reach = full_circle / phases;
  std::uintmax_t evaluations = 40;
  const auto [at, value] = boost::math::tools::brent_find_minima(
      [&](double there) { return sign * margin_of(motion.machine, turn_at(motion, there), rank); },
      phase - reach, phase + reach, phase_bits, evaluations);
  return value < found.value ? Valley{at, value} : found;
}

/// See rank_margin.
double found_margin(const DisturbedMotion& motion, int rank, Extreme extreme) {
  if (motion.turns.empty()) {
    DisturbedMotion long_motion = motion;
    observe(long_motion);
    return found_margin(long_motion, rank, extreme);
  }
  const PhaseMargins margins(motion, rank, extreme);
  if (!motion.settled || std::abs(margins.least()) > refined_within) {
    return margins.sign() * margins.least();
  }
  double refined = std::numeric_limits<double>::infinity();
  for (const std::size_t k : margins.valleys()) {
    if (margins.at(k) > refined + refined_within) continue;
    const Valley valley = least_near(motion, rank, margins.sign(), motion.turns[k].phase);
    refined = std::min({refined, margins.at(k), valley.value});
  }
  return margins.sign() * refined;
}

}  // namespace

DisturbedTurn turn_at(const DisturbedMotion& motion, double phase) {
  return turns_at_phases(motion.machine, std::span(&phase, 1), motion.turns_before).front();
}

double sampled_margin(const DisturbedMotion& motion, int rank, Extreme extreme) {
  const PhaseMargins margins(motion, rank, extreme);
  return margins.sign() * margins.least();
}

double rank_margin(const DisturbedMotion& motion, int rank, Extreme extreme) {
  for (const KnownMargin& known : motion.known) {
    if (known.rank == rank && known.extreme == extreme) return known.value;
  }
  motion.known.push_back({rank, extreme, found_margin(motion, rank, extreme)});
  return motion.known.back().value;
}

ExtremeMargin::ExtremeMargin(const DisturbedMotion& motion, int rank, Extreme extreme)
    : motion_(motion), rank_(rank) {
  const PhaseMargins margins(motion, rank, extreme);
  sign_ = margins.sign();
  phase_ = motion.turns[margins.deepest()].phase;
}

double ExtremeMargin::at(double omega) {
  motion_.machine = at_speed(motion_.machine, omega);
  const Valley valley = least_near(motion_, rank_, sign_, phase_);
  phase_ = valley.phase;
  return sign_ * valley.value;
}

LongRun long_run_of(const DisturbedMotion& motion) {
  if (!motion.moves) return {motion.machine, 0, 0, 0, 1};
  std::vector<ObservedTurn> turns;
  if (!motion.settled) {
    turns = irregular_turns_of(motion.machine);
  } else {
    turns = observed_turns(motion.machine, even_phases(), motion.turns_before, 1);
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
  DisturbedMotion motion{scene, 0, true, true, {}, 0, 0, {}};
  Scene& machine = motion.machine;
  begin_turns_at_rest(machine);
  const bool pressed_down =
      release_margin(machine, machine.wall_lower) <= release_margin(machine, machine.wall_upper);
  machine.start_position =
      pressed_down || !std::isfinite(machine.wall_upper) ? machine.wall_lower : machine.wall_upper;
  machine.start_velocity = 0;
  if (release_margin(machine, machine.start_position) <= 0) {
    motion.moves = false;
    motion.turns = {{0, {}, {}, 0, true}};
    return motion;
  }
  take_turns(motion);
  if (!motion.settled) return motion;
  take_extremes(motion);
  // Between the phases there may be turns with fewer and with more.
  while (motion.least > 0 && !(rank_margin(motion, motion.least, Extreme::least) > 0)) {
    --motion.least;
  }
  while (rank_margin(motion, motion.most + 1, Extreme::most) > 0) ++motion.most;
  return motion;
}

}  // namespace ricochet::carrier_track::inline regimes
