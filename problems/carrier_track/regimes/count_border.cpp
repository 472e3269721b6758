#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "problems/carrier_track/regimes/border.h"
#include "problems/carrier_track/regimes/sampled_turns.h"

namespace ricochet::carrier_track::inline regimes {

namespace {

constexpr double beside = 1e-10;       // relative, on both sides of a tip
constexpr int most_tips = 8;           // that are tried, of other phases
constexpr double without_jump = 1e-5;  // a margin so small on both sides passes 0
constexpr double first_reach = 1e-3;   // relative, back to where turns may have begun
constexpr double farthest_back = 0.5;  // the same, at most

/// Finds where the turns begin or end in which the rank-th fastest impact counts, or does not.
class CountBorder {
 public:
  CountBorder(int rank, Extreme extreme) : rank_(rank), extreme_(extreme) {}

  /// Where they begin, or end, between two motions.
  std::optional<Border<DisturbedMotion>> between(const DisturbedMotion& near,
                                                 const DisturbedMotion& far) const {
    const bool begin = !has_beyond(near);
    const DisturbedMotion& outside = begin ? near : far;
    DisturbedMotion inside = begin ? far : near;
    double last = 0;
    for (int tries = 0; tries < most_tips; ++tries) {
      const double phase = phase_beyond(inside);
      const auto tip = phase_tip(inside, rank_, extreme_, phase, outside.omega());
      if (!tip) return std::nullopt;
      if (!tip->is_reached)
        return begin ? begun_before(near, phase_in(near, inside, tip->phase))
                     : after(near, far, tip->phase);
      const double away = outside.omega() < inside.omega() ? -beside : beside;
      DisturbedMotion end = followed(outside, tip->omega * (1 + away));
      if (!signature_of(end).same_kind(signature_of(outside))) return first_border(near, end);
      if (!has_beyond(end)) return at(*tip, inside, begin, end);
      if (std::abs(tip->omega - last) <= 3 * beside * last) {
        end.least = outside.least;
        end.most = outside.most;
        return at(*tip, inside, begin, end);
      }
      last = tip->omega;  // another phase is beyond, too
      inside = std::move(end);
    }
    return std::nullopt;
  }

 private:
  /// Whether some turns of a motion are such.
  bool has_beyond(const DisturbedMotion& motion) const {
    return extreme_ == Extreme::most ? motion.most >= rank_ : motion.least < rank_;
  }

  /// A phase of such a turn.
  double phase_beyond(const DisturbedMotion& motion) const {
    std::optional<PhaseMargin> best;
    const double sign = sign_of(extreme_);
    for (const auto* turns : {&motion.turns, &motion.watched}) {
      for (const DisturbedTurn& turn : *turns) {
        const double margin = margin_of(motion.machine, turn, rank_);
        if (!is_beyond(extreme_, margin) || (best && sign * margin >= sign * best->value)) continue;
        best = {margin, turn.phase};
      }
    }
    return best ? best->phase : extreme_margin(motion, rank_, extreme_).phase;
  }

  /// The border at a tip of the turns of `inside`, beside which `end` has no such turns.
  Border<DisturbedMotion> at(const PhaseTip& tip, const DisturbedMotion& inside, bool begins,
                             DisturbedMotion end) const {
    DisturbedMotion beyond = end;
    beyond.machine =
        at_speed(end.machine, tip.omega * (1 + (end.omega() < tip.omega ? beside : -beside)));
    beyond.known.clear();
    if (extreme_ == Extreme::most) {
      beyond.most = std::max(beyond.most, rank_);
    } else {
      beyond.least = std::min(beyond.least, rank_ - 1);
    }
    const double phase = phase_in(end, inside, tip.phase);
    const auto margin = [&](const DisturbedMotion& motion) {
      return std::abs(margin_of(motion.machine, turn_at(motion, phase), rank_));
    };
    const bool passes = margin(end) < without_jump && margin(beyond) < without_jump;
    watch(beyond, phase + tip.drift * (beyond.omega() - tip.omega));
    if (!begins) std::swap(end, beyond);
    return {tip.omega, passes ? RegimeEnd::counting_limit : RegimeEnd::grazing, std::move(end),
            std::move(beyond)};
  }

  /// The border where such turns do not end by the speed of `far`, though no even phase has met
  /// them there.
  std::optional<Border<DisturbedMotion>> after(const DisturbedMotion& near,
                                               const DisturbedMotion& far, double phase) const {
    DisturbedMotion watching = far;
    watch(watching, phase_in(far, near, phase));
    if (!has_beyond(watching)) return std::nullopt;
    if (!(signature_of(watching) == signature_of(near))) return first_border(near, watching);
    return Border<DisturbedMotion>{watching.omega(), RegimeEnd::grazing, near, watching};
  }

  /// The border where such turns began before `near`, which has one at this phase; at `near` itself
  /// if they cannot be followed that far.
  std::optional<Border<DisturbedMotion>> begun_before(const DisturbedMotion& near,
                                                      double phase) const {
    DisturbedMotion watching = near;
    watch(watching, phase);
    if (!has_beyond(watching)) return std::nullopt;
    DisturbedMotion inside = watching;
    for (double reach = first_reach; reach < farthest_back; reach *= 4) {
      const double until = near.omega() * (1 - reach);
      const auto tip = phase_tip(inside, rank_, extreme_, phase, until);
      if (!tip) break;
      DisturbedMotion end = followed(near, tip->is_reached ? tip->omega * (1 - beside) : until);
      if (!signature_of(end).same_kind(signature_of(near))) break;
      if (tip->is_reached && !has_beyond(end)) return at(*tip, inside, true, end);
      phase = has_beyond(end) ? phase_beyond(end) : phase_in(end, inside, tip->phase);
      inside = std::move(end);
      watch(inside, phase);
    }
    return Border<DisturbedMotion>{near.omega(), RegimeEnd::grazing, near, watching};
  }

  int rank_;
  Extreme extreme_;
};

}  // namespace

std::optional<Border<DisturbedMotion>> count_border(const DisturbedMotion& near,
                                                    const DisturbedMotion& far, int rank,
                                                    Extreme extreme) {
  return CountBorder(rank, extreme).between(near, far);
}

namespace {

constexpr int phase_bits = 24;         // of an extreme phase: its margin has twice as many
constexpr double widest_window = 0.1;  // [rad], to each side, in which extremes are searched
constexpr double narrowest_window = 1e-4;
constexpr double jump = 1e-4;            // more than that, where an impact appears or vanishes
constexpr double smooth = 1e-11;         // relative, what a polynomial may leave out
constexpr double refined_within = 0.02;  // margins nearer to 0 are searched, not interpolated

/// The least value of the parabola through the values at -1, 0 and 1, of which that at 0 is the
/// least.
double vertex_of(double before, double here, double after) {
  const double bend = before - 2 * here + after;
  if (!(bend > 0)) return here;
  const double place = (before - after) / (2 * bend);
  return here - bend * place * place / 2;
}

/// The margins of an impact over the even phases, with a sign that makes the extreme one the least.
class EvenMargins {
 public:
  EvenMargins(const DisturbedMotion& motion, int rank, Extreme extreme)
      : sign_(sign_of(extreme)), settled_(motion.settled) {
    for (const DisturbedTurn& turn : motion.turns) {
      values_.push_back(sign_ * margin_of(motion.machine, turn, rank));
    }
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
    if (!interpolates() || std::abs(least) >= -lowest_margin) return least;
    for (const std::size_t k : valleys()) {
      least = std::min(least, vertex_of(at(k + values_.size() - 1), at(k), at(k + 1)));
    }
    return least;
  }

  /// Whether the least may be on the other side of 0 than the parabola says, or is near 0. Where an
  /// impact appears, a parabola goes far beyond what is true.
  bool is_unsure() const {
    const double interpolated = least();
    return settled_ && values_.size() > 2 &&
           (std::abs(interpolated) <= refined_within || (interpolated > 0) != (at(deepest()) > 0));
  }

 private:
  bool interpolates() const { return settled_ && values_.size() > 2; }

  double sign_;
  bool settled_;
  std::vector<double> values_;
};

/// With the sign that makes an extreme the least.
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
  const double reach = 2 * std::numbers::pi / static_cast<double>(motion.turns.size());
  std::uintmax_t evaluations = 40;
  const auto [at, value] = boost::math::tools::brent_find_minima(
      [&](double there) { return sign * margin_of(motion.machine, turn_at(motion, there), rank); },
      phase - reach, phase + reach, phase_bits, evaluations);
  return value < found.value ? Valley{at, value} : found;
}

Valley searched(const DisturbedMotion& motion, int rank, const EvenMargins& margins) {
  Valley deepest{0, std::numeric_limits<double>::infinity()};
  for (const std::size_t k : margins.valleys()) {
    if (margins.at(k) > deepest.value + refined_within) continue;
    const double phase = motion.turns[k].phase;
    const Valley valley = least_near(motion, rank, margins.sign(), phase);
    if (margins.at(k) < deepest.value) deepest = {phase, margins.at(k)};
    if (valley.value < deepest.value) deepest = valley;
  }
  return deepest;
}

PhaseMargin found_margin(const DisturbedMotion& motion, int rank, Extreme extreme) {
  if (motion.turns.empty()) {
    DisturbedMotion long_motion = motion;
    observe(long_motion);
    return found_margin(long_motion, rank, extreme);
  }
  const EvenMargins margins(motion, rank, extreme);
  Valley found{motion.turns[margins.deepest()].phase, margins.least()};
  if (margins.is_unsure()) found = searched(motion, rank, margins);
  for (const DisturbedTurn& turn : motion.watched) {
    const double value = margins.sign() * margin_of(motion.machine, turn, rank);
    if (value < found.value) found = {turn.phase, value};
  }
  return {margins.sign() * found.value, found.phase};
}

}  // namespace

PhaseMargin sampled_margin(const DisturbedMotion& motion, int rank, Extreme extreme) {
  const EvenMargins margins(motion, rank, extreme);
  return {margins.sign() * margins.least(), motion.turns[margins.deepest()].phase};
}

PhaseMargin extreme_margin(const DisturbedMotion& motion, int rank, Extreme extreme) {
  for (const KnownMargin& known : motion.known) {
    if (known.rank == rank && known.extreme == extreme) return {known.value, known.phase};
  }
  const PhaseMargin found = found_margin(motion, rank, extreme);
  motion.known.push_back({rank, extreme, found.value, found.phase});
  return found;
}

}  // namespace ricochet::carrier_track::inline regimes
