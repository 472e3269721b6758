#include "problems/carrier_track/regimes/border.h"

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "problems/carrier_track/regimes/fold.h"
#include "problems/carrier_track/regimes/phase_margin.h"
#include "problems/carrier_track/regimes/phase_tip.h"
#include "problems/carrier_track/regimes/release_margin.h"

namespace ricochet::carrier_track::inline regimes {
namespace {

constexpr double narrow = 1e-13;     // relative width at which a bracket is a border
constexpr double blurred = 1e-5;     // the same beside a motion that does not repeat
constexpr double beside = 1e-10;     // relative, on both sides of a root that is known
constexpr int most_tips = 8;         // that are tried, of other phases
constexpr double continuous = 1e-5;  // a margin so small on both sides passes 0 without a jump
constexpr double near_bifurcation = 1e-2;  // of eigenvalue conditions, at the end of a bisection
constexpr double just_beyond = 1e-4;  // relative, where a new motion is large enough to be seen

bool is_narrow(double a, double b) {
  return std::abs(b - a) <= narrow * std::abs(b);
}

/// Motions on both sides of a border.
template <class Motion>
struct Bracket {
  Motion before, after;

  double from() const { return before.omega(); }
  double to() const { return after.omega(); }
  bool upwards() const { return from() < to(); }
};

/// Narrows a bracket to the sign change of a margin of the motion.
template <class Of>
Bracket<SteadyMotion> sign_change(Bracket<SteadyMotion> bracket, const Of& margin) {
  const bool side = margin(bracket.before) > 0;
  const auto at = [&](double omega) {
    SteadyMotion motion = followed(bracket.before, omega);
    const double there = margin(motion);
    ((there > 0) == side ? bracket.before : bracket.after) = std::move(motion);
    return there;
  };
  const bool up = bracket.upwards();
  const SteadyMotion low = up ? bracket.before : bracket.after;
  const SteadyMotion high = up ? bracket.after : bracket.before;
  std::uintmax_t evaluations = 100;
  const double root = boost::math::tools::toms748_solve(at, low.omega(), high.omega(), margin(low),
                                                        margin(high), is_narrow, evaluations)
                          .first;
  // The solver stops at a margin of exactly 0, which is on one side of the border: the other side
  // is next to it.
  const double away = bracket.before.omega() == root ? (up ? 1 : -1) : (up ? -1 : 1);
  for (double step = narrow / 8; !is_narrow(bracket.from(), bracket.to()); step *= 4) {
    const double there = root * (1 + away * step);
    if (!(std::min(bracket.from(), bracket.to()) < there &&
          there < std::max(bracket.from(), bracket.to()))) {
      break;
    }
    at(there);
  }
  // Where the margin is 0 at an end, it may touch 0 there, and change its sign farther on.
  const double width = std::abs(bracket.to() - bracket.from());
  const bool again = width < high.omega() - low.omega() && !is_narrow(bracket.from(), bracket.to());
  return again ? sign_change(bracket, margin) : bracket;
}

/// Narrows a bracket to the place where `stays(signature)` becomes false.
template <class Motion, class Stays>
Bracket<Motion> change(Bracket<Motion> bracket, const Stays& stays) {
  for (;;) {
    const double width = std::abs(bracket.to() - bracket.from());
    // What settles slowly has no sharper border.
    const bool settled = bracket.before.settled && bracket.after.settled;
    if (width <= (settled ? narrow : blurred) * bracket.to()) return bracket;
    const double middle = 0.5 * (bracket.from() + bracket.to());
    if (middle == bracket.from() || middle == bracket.to()) return bracket;
    Motion motion = followed(bracket.before, middle);
    (stays(signature_of(motion)) ? bracket.before : bracket.after) = std::move(motion);
  }
}

double position_of(const SteadyMotion& still) {
  return still.orbit.start_position;
}
double position_of(const DisturbedMotion& still) {
  return still.machine.start_position;
}
const Scene& machine_of(const SteadyMotion& motion) {
  return motion.orbit;
}
const Scene& machine_of(const DisturbedMotion& motion) {
  return motion.machine;
}

/// The speed at which the carrier of a motion without motion starts to move.
template <class Motion>
double release_speed(const Motion& still, double until) {
  const auto margin = [&](double omega) {
    return release_margin(at_speed(machine_of(still), omega), position_of(still));
  };
  const double low = std::min(still.omega(), until);
  const double high = std::max(still.omega(), until);
  std::uintmax_t evaluations = 100;
  const auto [a, b] = boost::math::tools::toms748_solve(margin, low, high, margin(low),
                                                        margin(high), is_narrow, evaluations);
  return 0.5 * (a + b);
}

template <class Motion>
Border<Motion> release(const Bracket<Motion>& bracket) {
  const double omega = release_speed(bracket.before, bracket.to());
  const double away = bracket.upwards() ? 1 : -1;
  return {omega, RegimeEnd::release, followed(bracket.before, omega * (1 - 1e-12 * away)),
          followed(bracket.before, omega * (1 + just_beyond * away))};
}

/// What changes between motions of different kind, if it is no bifurcation of an orbit.
RegimeEnd change_of(const Signature& before, const Signature& after) {
  if (before.moves != after.moves) return RegimeEnd::release;
  if (before.settled != after.settled) return RegimeEnd::irregular;
  if (before.rests && !after.rests) return RegimeEnd::end_of_rest;
  if (!before.rests && after.rests) return RegimeEnd::start_of_rest;
  return RegimeEnd::grazing;
}

/// The border at the end of a narrow bracket.
Border<SteadyMotion> solved(const Bracket<SteadyMotion>& bracket) {
  const SteadyMotion& end = bracket.before;
  const auto beyond = [&] {
    Scene scene =
        at_speed(end.orbit, end.omega() * (bracket.upwards() ? 1 + just_beyond : 1 - just_beyond));
    scene.start_velocity *= 1 + just_beyond;
    return steady_motion(scene);
  };
  if (end.settled && end.rest == Rest::never) {
    if (end.flip_margin() < near_bifurcation) {
      return {end.omega(), RegimeEnd::flip, end, beyond()};
    }
    if (end.fold_margin() < near_bifurcation) {
      return {fold_near(end).value_or(end.omega()), RegimeEnd::fold, end, beyond()};
    }
  }
  return {bracket.to(), change_of(signature_of(end), signature_of(bracket.after)), end,
          bracket.after};
}

Border<DisturbedMotion> solved(const Bracket<DisturbedMotion>& bracket) {
  return {bracket.to(), change_of(signature_of(bracket.before), signature_of(bracket.after)),
          bracket.before, bracket.after};
}

template <class Motion>
Border<Motion> border_within(const Bracket<Motion>& bracket);

template <class Motion>
Border<Motion> border_of_kind(const Bracket<Motion>& bracket) {
  const Signature kind = signature_of(bracket.before);
  if (!kind.moves) return release(bracket);
  const Bracket<Motion> end =
      change(bracket, [&](const Signature& there) { return there.same_kind(kind); });
  // The count may have changed before the kind did.
  if (!(signature_of(end.before) == kind))
    return border_within<Motion>({bracket.before, end.before});
  return solved(end);
}

Border<SteadyMotion> border_of_count(const Bracket<SteadyMotion>& bracket, int rank,
                                     Extreme /*extreme*/) {
  const auto margin = [rank](const SteadyMotion& motion) { return rank_margin(motion, rank); };
  const Bracket<SteadyMotion> end = sign_change(bracket, margin);
  // The kind may have changed, and changed back, on the way.
  if (!signature_of(end.before).same_kind(signature_of(bracket.before))) {
    return border_of_kind<SteadyMotion>({bracket.before, end.before});
  }
  const bool passes =
      std::abs(margin(end.before)) < continuous && std::abs(margin(end.after)) < continuous;
  return {end.to(), passes ? RegimeEnd::counting_limit : RegimeEnd::grazing, end.before, end.after};
}

/// Whether some turns of a motion count so.
bool has_beyond(const DisturbedMotion& motion, int rank, Extreme extreme) {
  return extreme == Extreme::most ? motion.most >= rank : motion.least < rank;
}

/// A phase at which a turn counts so.
double phase_beyond(const DisturbedMotion& motion, int rank, Extreme extreme) {
  std::optional<PhaseMargin> best;
  for (const auto* turns : {&motion.turns, &motion.watched}) {
    for (const DisturbedTurn& turn : *turns) {
      const double margin = margin_of(motion.machine, turn, rank);
      const double sign = sign_of(extreme);
      if (!is_beyond(extreme, margin) || (best && sign * margin >= sign * best->value)) continue;
      best = {margin, turn.phase};
    }
  }
  return best ? best->phase : extreme_margin(motion, rank, extreme).phase;
}

/// A motion next to `end` at a border, where the turn at that phase counts, or does not.
DisturbedMotion just_beyond_tip(const DisturbedMotion& end, double omega, int rank,
                                Extreme extreme) {
  DisturbedMotion beyond = end;
  beyond.machine = at_speed(end.machine, omega);
  beyond.known.clear();
  if (extreme == Extreme::most) {
    beyond.most = std::max(beyond.most, rank);
  } else {
    beyond.least = std::min(beyond.least, rank - 1);
  }
  return beyond;
}

/// A speed before the bracket at which the turn at that phase does not count so.
std::optional<double> before_opening(const Bracket<DisturbedMotion>& bracket, int rank,
                                     Extreme extreme, double phase) {
  const double back = bracket.upwards() ? -1 : 1;
  for (double step = just_beyond; step < 0.1; step *= 4) {
    const double omega = bracket.from() * (1 + back * step);
    const Scene machine = machine_at(bracket.after, omega, phase);
    const DisturbedTurn turn = turns_of({&machine, 1}, bracket.after.turns_before).front();
    if (!is_beyond(extreme, margin_of(machine, turn, rank))) return omega;
  }
  return std::nullopt;
}

/// The border where the first or last phase counts so.
Border<DisturbedMotion> border_of_count(const Bracket<DisturbedMotion>& bracket, int rank,
                                        Extreme extreme) {
  const bool opens = !has_beyond(bracket.before, rank, extreme);
  DisturbedMotion outside = opens ? bracket.before : bracket.after;
  DisturbedMotion inside = opens ? bracket.after : bracket.before;
  std::optional<DisturbedMotion> seen;  // at the bracket's start, if turns count so there
  double last = 0;
  for (int tries = 0; tries < most_tips; ++tries) {
    const double phase = phase_beyond(inside, rank, extreme);
    const std::optional<PhaseTip> tip = phase_tip(inside, rank, extreme, phase, outside.omega());
    if (!tip) break;
    if (!tip->is_reached && !opens) {
      DisturbedMotion far = bracket.after;
      watch(far, tip->phase);
      if (!has_beyond(far, rank, extreme)) break;
      if (signature_of(far) == signature_of(bracket.before)) {
        return {far.omega(), RegimeEnd::grazing, bracket.before, far};
      }
      return border_within<DisturbedMotion>({bracket.before, far});
    }
    if (!tip->is_reached) {  // it opened before, unseen
      if (!seen) {
        seen = bracket.before;
        watch(*seen, tip->phase);
      }
      const std::optional<double> earlier = before_opening(bracket, rank, extreme, tip->phase);
      if (earlier) outside = followed(bracket.before, *earlier);
      if (!earlier || !(signature_of(outside) == signature_of(bracket.before))) {
        return {bracket.from(), RegimeEnd::grazing, bracket.before, *seen};
      }
      continue;
    }
    const double away = outside.omega() < inside.omega() ? -beside : beside;
    DisturbedMotion end = followed(outside, tip->omega * (1 + away));
    if (!signature_of(end).same_kind(signature_of(outside))) {
      return border_of_kind<DisturbedMotion>({bracket.before, end});
    }
    if (has_beyond(end, rank, extreme)) {
      const bool again = std::abs(tip->omega - last) <= 3 * beside * last;
      last = tip->omega;
      inside = std::move(end);
      if (!again) continue;  // another phase is beyond, too
      end = inside;
      end.least = outside.least;
      end.most = outside.most;
    }
    const double past = tip->omega * (1 - away);
    DisturbedMotion beyond = just_beyond_tip(end, past, rank, extreme);
    const auto margin = [&](const DisturbedMotion& motion) {
      return std::abs(margin_of(motion.machine, turn_at(motion, tip->phase), rank));
    };
    const bool passes = margin(end) < continuous && margin(beyond) < continuous;
    watch(beyond, tip->phase);
    return {tip->omega, passes ? RegimeEnd::counting_limit : RegimeEnd::grazing,
            opens ? end : beyond,
            seen    ? *seen
            : opens ? beyond
                    : end};
  }
  const Signature first = signature_of(bracket.before);
  const Bracket<DisturbedMotion> end =
      change(bracket, [&](const Signature& there) { return there == first; });
  if (!signature_of(end.before).same_kind(first)) {
    return border_of_kind<DisturbedMotion>({bracket.before, end.before});
  }
  return {end.to(), RegimeEnd::grazing, end.before, end.after};
}

template <class Motion>
Border<Motion> border_within(const Bracket<Motion>& bracket) {
  const Signature a = signature_of(bracket.before);
  const Signature b = signature_of(bracket.after);
  if (!a.same_kind(b)) return border_of_kind(bracket);
  std::vector<Border<Motion>> found;
  if (a.most != b.most) {
    found.push_back(border_of_count(bracket, b.most > a.most ? a.most + 1 : a.most, Extreme::most));
  }
  if (a.least != b.least && (found.empty() || a.least != a.most || b.least != b.most)) {
    found.push_back(
        border_of_count(bracket, b.least > a.least ? a.least + 1 : a.least, Extreme::least));
  }
  return *std::min_element(found.begin(), found.end(), [&](const auto& x, const auto& y) {
    return std::abs(x.omega - bracket.from()) < std::abs(y.omega - bracket.from());
  });
}

}  // namespace

Border<SteadyMotion> first_border(const SteadyMotion& near, const SteadyMotion& far) {
  return border_within<SteadyMotion>({near, far});
}

Border<DisturbedMotion> first_border(const DisturbedMotion& near, const DisturbedMotion& far) {
  return border_within<DisturbedMotion>({near, far});
}

}  // namespace ricochet::carrier_track::inline regimes
