#include "problems/carrier_track/regimes/count_border.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "problems/carrier_track/regimes/phase_margin.h"
#include "problems/carrier_track/regimes/phase_tip.h"

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

}  // namespace ricochet::carrier_track::inline regimes
