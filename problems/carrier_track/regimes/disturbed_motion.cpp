#include "problems/carrier_track/regimes/disturbed_motion.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/counting/wear.h"
#include "problems/carrier_track/flight/applied_forces.h"
#include "problems/carrier_track/models/impact_model.h"
#include "problems/carrier_track/regimes/followed_motion.h"
#include "problems/carrier_track/regimes/release_margin.h"
#include "problems/carrier_track/regimes/steady_motion.h"
#include "problems/carrier_track/scene/window.h"

namespace ricochet::carrier_track::inline regimes {
namespace {

constexpr double full_circle = 2 * std::numbers::pi;
constexpr int phases = 16;
constexpr int erasing_turns = 2;      // whose rests erase the start, if it is not where turns start
constexpr int irregular_turns = 120;  // observed where they do not, after as many
constexpr int phase_bits = 24;        // of an extreme phase: its margin has twice as many
constexpr double refined_within = 0.02;  // margins nearer to 0 are searched, not interpolated

/// What happens in the last turns of a window.
class LastTurns : public Observer {
 public:
  LastTurns(const Scene& scene, int before, int turns)
      : scene_(scene), turn_(full_circle / scene.omega), start_(turn_ * before) {
    for (int k = 0; k < turns; ++k) turns_.push_back({scene.disturbance_phase, {}, 0, 0, 0});
  }

  void impact(double time, Wall wall, double speed) {
    DisturbedTurn* turn = at(time);
    if (turn == nullptr || speed <= 0) return;
    turn->speeds.push_back(speed);
    turn->energy += impact_loss(scene_, wall) * speed * speed;
    if (is_counted(speed, scene_.counting_limit)) ++turn->collisions;
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

  std::vector<DisturbedTurn> turns() {
    for (DisturbedTurn& turn : turns_) {
      std::sort(turn.speeds.begin(), turn.speeds.end(), std::greater<>());
    }
    return turns_;
  }

 private:
  DisturbedTurn* at(double time) {
    if (time < start_) return nullptr;
    const auto k = static_cast<std::size_t>((time - start_) / turn_);
    return k < turns_.size() ? &turns_[k] : nullptr;
  }

  const Scene& scene_;
  double turn_, start_;  // [s]
  std::vector<DisturbedTurn> turns_;
};

struct Run {
  std::vector<DisturbedTurn> turns;
  bool returns;  ///< ends at rest where it started
};

Run run(Scene scene, double phase, int before, int turns) {
  scene.disturbance_phase = phase;
  scene.window = Revolutions{static_cast<double>(before + turns)};
  LastTurns last(scene, before, turns);
  const End<double> end = ImpactModel<double>(scene).run(last);
  return {last.turns(), end.position == scene.start_position && end.velocity == 0};
}

double margin_of(const Scene& scene, const DisturbedTurn& turn, int rank) {
  if (rank < 1 || rank > static_cast<int>(turn.speeds.size())) return lowest_margin;
  const double speed = turn.speeds[static_cast<std::size_t>(rank - 1)];
  return std::max(lowest_margin, std::log(speed / scene.counting_limit));
}

/// Lets the turns of the plate begin where its force passes zero from above: a carrier that rests
/// in every half turn then rests.
void begin_turns_at_rest(Scene& scene) {
  const auto plate = AppliedForces<double>(scene).flight(0, 0, 0).harmonic[0];
  scene.phase += std::numbers::pi / 2 - std::atan2(plate.sine, plate.cosine);
}

/// Whether what happened before the erasing turns is forgotten: starts on either wall lead to the
/// same turn.
bool forgets(DisturbedMotion motion) {
  Scene& machine = motion.machine;
  if (!std::isfinite(machine.wall_upper)) return true;
  const bool on_lower = machine.start_position == machine.wall_lower;
  machine.start_position = on_lower ? machine.wall_upper : machine.wall_lower;
  for (std::size_t k = 0; k < motion.turns.size(); k += 5) {
    const DisturbedTurn& here = motion.turns[k];
    const DisturbedTurn turn = turn_at(motion, here.phase);
    if (turn.collisions != here.collisions) return false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(turn.collisions); ++i) {
      if (std::abs(turn.speeds[i] / here.speeds[i] - 1) > 1e-9) return false;
    }
  }
  return true;
}

/// Takes the turns of all phases from a start at rest on that wall. Returns whether all end there.
bool all_return(DisturbedMotion& motion, double wall) {
  if (!std::isfinite(wall)) return false;
  motion.machine.start_position = wall;
  motion.turns.clear();
  for (int k = 0; k < phases; ++k) {
    const Run turn = run(motion.machine, full_circle * k / phases, 0, 1);
    if (!turn.returns) return false;
    motion.turns.push_back(turn.turns.front());
  }
  return true;
}

/// Takes the turns of a motion that moves.
void take_turns(DisturbedMotion& motion) {
  const Scene machine = motion.machine;
  if (all_return(motion, machine.wall_upper) || all_return(motion, machine.wall_lower)) return;
  motion.machine = machine;
  motion.turns_before = erasing_turns;
  motion.turns.clear();
  for (int k = 0; k < phases; ++k) {
    motion.turns.push_back(turn_at(motion, full_circle * k / phases));
  }
  motion.settled = forgets(motion);
  if (motion.settled) return;
  motion.turns = run(machine, machine.disturbance_phase, irregular_turns, irregular_turns).turns;
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
class Margins {
 public:
  Margins(const DisturbedMotion& motion, int rank, Extreme extreme)
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

/// The least margin, with that sign, within a step of the phases of `phase`.
Valley least_near(const DisturbedMotion& motion, int rank, double sign, double phase) {
  const double reach = full_circle / phases;
  std::uintmax_t evaluations = 40;
  const auto [at, value] = boost::math::tools::brent_find_minima(
      [&](double there) { return sign * margin_of(motion.machine, turn_at(motion, there), rank); },
      phase - reach, phase + reach, phase_bits, evaluations);
  return {at, value};
}

}  // namespace

double DisturbedMotion::mean_collisions() const {
  double sum = 0;
  for (const DisturbedTurn& turn : turns) sum += turn.collisions;
  return sum / static_cast<double>(turns.size());
}

DisturbedTurn turn_at(const DisturbedMotion& motion, double phase) {
  return run(motion.machine, phase, motion.turns_before, 1).turns.front();
}

double sampled_margin(const DisturbedMotion& motion, int rank, Extreme extreme) {
  const Margins margins(motion, rank, extreme);
  return margins.sign() * margins.least();
}

double rank_margin(const DisturbedMotion& motion, int rank, Extreme extreme) {
  const Margins margins(motion, rank, extreme);
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

ExtremeMargin::ExtremeMargin(const DisturbedMotion& motion, int rank, Extreme extreme)
    : motion_(motion), rank_(rank) {
  const Margins margins(motion, rank, extreme);
  sign_ = margins.sign();
  phase_ = motion.turns[margins.deepest()].phase;
}

double ExtremeMargin::at(double omega) {
  motion_.machine = at_speed(motion_.machine, omega);
  const Valley valley = least_near(motion_, rank_, sign_, phase_);
  phase_ = valley.phase;
  return sign_ * valley.value;
}

DisturbedMotion disturbed_motion(const Scene& scene) {
  DisturbedMotion motion{scene, 0, true, true, {}, 0, 0};
  Scene& machine = motion.machine;
  begin_turns_at_rest(machine);
  const bool pressed_down =
      release_margin(machine, machine.wall_lower) <= release_margin(machine, machine.wall_upper);
  machine.start_position =
      pressed_down || !std::isfinite(machine.wall_upper) ? machine.wall_lower : machine.wall_upper;
  machine.start_velocity = 0;
  if (release_margin(machine, machine.start_position) <= 0) {
    motion.moves = false;
    motion.turns = {{0, {}, 0, 0, 1}};
    return motion;
  }
  take_turns(motion);
  const auto [least, most] =
      std::minmax_element(motion.turns.begin(), motion.turns.end(),
                          [](const auto& a, const auto& b) { return a.collisions < b.collisions; });
  motion.least = least->collisions;
  motion.most = most->collisions;
  // Between the phases there may be turns with fewer and with more.
  while (motion.settled && motion.least > 0 &&
         !(rank_margin(motion, motion.least, Extreme::least) > 0)) {
    --motion.least;
  }
  while (motion.settled && rank_margin(motion, motion.most + 1, Extreme::most) > 0) ++motion.most;
  return motion;
}

}  // namespace ricochet::carrier_track::inline regimes
