#include "problems/carrier_track/regimes/border.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "problems/carrier_track/motion/forces.h"
#include "problems/carrier_track/regimes/followed_motion.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "src/core/bracketed_root.h"

namespace ricochet::carrier_track::inline regimes {

namespace {

constexpr double narrow = 1e-13;     // relative width at which a bracket is a border
constexpr double blurred = 1e-5;     // the same beside a motion that does not repeat
constexpr double continuous = 1e-5;  // a margin so small on both sides passes 0 without a jump
constexpr double near_bifurcation = 1e-2;  // of eigenvalue conditions, at the end of a bisection
constexpr double just_beyond = 1e-4;  // relative, where a new motion is large enough to be seen

bool is_narrow(double a, double b) {
  return std::abs(b - a) <= narrow * std::abs(b);
}

/// Motions on both sides of a border.
struct Bracket {
  SteadyMotion before, after;

  double from() const { return before.omega(); }
  double to() const { return after.omega(); }
  bool upwards() const { return from() < to(); }
};

/// Narrows a bracket to the sign change of a margin of the motion.
template <class Of>
Bracket sign_change(Bracket bracket, const Of& margin) {
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
  const double root =
      bracketed_root(at, low.omega(), high.omega(), margin(low), margin(high), is_narrow).first;
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
template <class Stays>
Bracket change(Bracket bracket, const Stays& stays) {
  for (;;) {
    const double width = std::abs(bracket.to() - bracket.from());
    // What settles slowly has no sharper border.
    const bool settled = bracket.before.settled && bracket.after.settled;
    if (width <= (settled ? narrow : blurred) * bracket.to()) return bracket;
    const double middle = 0.5 * (bracket.from() + bracket.to());
    if (middle == bracket.from() || middle == bracket.to()) return bracket;
    SteadyMotion motion = followed(bracket.before, middle);
    (stays(signature_of(motion)) ? bracket.before : bracket.after) = std::move(motion);
  }
}

/// The speed at which the carrier of a motion without motion starts to move; nothing if rounding
/// hides where.
std::optional<double> release_speed(const SteadyMotion& still, double until) {
  const auto margin = [&](double omega) {
    return release_margin(at_speed(still.orbit, omega), still.orbit.start_position);
  };
  const double low = std::min(still.omega(), until);
  const double high = std::max(still.omega(), until);
  if ((margin(low) > 0) == (margin(high) > 0)) return std::nullopt;
  const auto [a, b] = bracketed_root(margin, low, high, margin(low), margin(high), is_narrow);
  return 0.5 * (a + b);
}

Border release(const Bracket& bracket) {
  const std::optional<double> omega = release_speed(bracket.before, bracket.to());
  if (!omega) {
    const Bracket end = change(bracket, [](const Signature& there) { return !there.moves; });
    return {end.to(), RegimeEnd::release, end.before, end.after};
  }
  const double away = bracket.upwards() ? 1 : -1;
  const auto beyond = [&](double by) { return followed(bracket.before, *omega * (1 + by * away)); };
  SteadyMotion after = beyond(just_beyond);
  // Next to the border the motion may be so slow that no impact counts.
  for (double by = just_beyond / 8; by > 1e-9 && signature_of(after).collisions > 0; by /= 8) {
    SteadyMotion nearer = beyond(by);
    const Signature there = signature_of(nearer);
    if (there.settled && there.moves && there.collisions == 0) after = std::move(nearer);
  }
  return {*omega, RegimeEnd::release, beyond(-1e-12), after};
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
Border solved(const Bracket& bracket) {
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

Border border_within(const Bracket& bracket, int tries);

/// Among motions that do not settle, kind and count may change in turn without end: after so many
/// `tries` the place where the kind changes is the border.
Border border_of_kind(const Bracket& bracket, int tries) {
  const Signature kind = signature_of(bracket.before);
  if (!kind.moves) return release(bracket);
  const Bracket end =
      change(bracket, [&](const Signature& there) { return there.same_kind(kind); });
  // The count may have changed before the kind did.
  const bool is_first = tries == 0 || signature_of(end.before) == kind;
  return is_first ? solved(end) : border_within({bracket.before, end.before}, tries - 1);
}

Border border_of_count(const Bracket& bracket, int rank, int tries) {
  const auto margin = [rank](const SteadyMotion& motion) { return rank_margin(motion, rank); };
  const Bracket end = sign_change(bracket, margin);
  // The kind may have changed, and changed back, on the way.
  if (!signature_of(end.before).same_kind(signature_of(bracket.before))) {
    return border_of_kind({bracket.before, end.before}, tries);
  }
  const bool passes =
      std::abs(margin(end.before)) < continuous && std::abs(margin(end.after)) < continuous;
  return {end.to(), passes ? RegimeEnd::counting_limit : RegimeEnd::grazing, end.before, end.after};
}

Border border_within(const Bracket& bracket, int tries) {
  const Signature a = signature_of(bracket.before);
  const Signature b = signature_of(bracket.after);
  if (!a.same_kind(b)) return border_of_kind(bracket, tries);
  const bool more = b.collisions > a.collisions;
  return border_of_count(bracket, more ? a.collisions + 1 : a.collisions, tries);
}

}  // namespace

Border first_border(const SteadyMotion& near, const SteadyMotion& far) {
  constexpr int most_tries = 10;
  return border_within({near, far}, most_tries);
}

namespace {

constexpr double difference = 1e-7;  // relative, of the margin's derivatives

double margin_of(const OrbitMap& map) {
  const MapInvariants invariants = invariants_of(map, Rest::never);
  return 1 - invariants.trace + invariants.determinant;
}

double margin_at(Scene scene, const Eigen::Vector3d& step) {
  scene.start_position += step[0];
  scene.start_velocity += step[1];
  scene.omega += step[2];
  return margin_of(map_of(scene, Rest::never));
}

}  // namespace

std::optional<double> fold_near(const SteadyMotion& orbit) {
  Scene scene = orbit.orbit;
  const double height = std::max(std::abs(scene.start_position - scene.wall_lower), 1e-12);
  const Eigen::Vector3d scales =
      difference * Eigen::Vector3d(height, orbit.fastest_impact(), scene.omega);
  for (int i = 0; i < 30; ++i) {
    const OrbitMap map = map_of(scene, Rest::never);
    const double margin = margin_of(map);
    Eigen::Matrix3d jacobian;
    for (int k = 0; k < 3; ++k) {
      jacobian(0, k) = map.position.v[k] - (k == OrbitMap::position_index ? 1 : 0);
      jacobian(1, k) = map.velocity.v[k] - (k == OrbitMap::velocity_index ? 1 : 0);
      const Eigen::Vector3d step = scales.cwiseProduct(Eigen::Vector3d::Unit(k));
      jacobian(2, k) = (margin_at(scene, step) - margin) / scales[k];
    }
    const Eigen::Vector3d miss(map.position.a - scene.start_position,
                               map.velocity.a - scene.start_velocity, margin);
    const Eigen::Vector3d step = jacobian.fullPivLu().solve(miss);
    if (!step.allFinite()) return std::nullopt;
    scene.start_position -= step[0];
    scene.start_velocity -= step[1];
    scene.omega -= step[2];
    const bool inside = scene.start_position >= scene.wall_lower &&
                        scene.start_position <= scene.wall_upper &&
                        std::abs(scene.omega / orbit.omega() - 1) < 1e-2;
    if (!inside) return std::nullopt;
    if (std::abs(step[2]) <= 1e-13 * scene.omega && std::abs(margin) < 1e-9) return scene.omega;
  }
  return std::nullopt;
}

bool keeps_sign(const Margin& a, const Margin& b, double step) {
  if ((a.value > 0) != (b.value > 0)) return false;
  const double sign = a.value > 0 ? 1 : -1;
  const double from = sign * a.value, to = sign * b.value;
  const double leaves = sign * step * a.slope, arrives = sign * step * b.slope;
  const double surprise = std::abs(to - from - (leaves + arrives) / 2);
  if (surprise > 0.5 * (from + to)) return false;
  const double square = 3 * (to - from) - 2 * leaves - arrives;
  const double cube = leaves + arrives - 2 * (to - from);
  // The least value within the step, where 3 cube t^2 + 2 square t + leaves = 0 and it rises.
  const double root = square * square - 3 * cube * leaves;
  if (root < 0) return true;
  const double t =
      square > 0 ? -leaves / (square + std::sqrt(root)) : (std::sqrt(root) - square) / (3 * cube);
  if (!(t > 0 && t < 1)) return true;
  const double least = from + t * (leaves + t * (square + t * cube));
  return least > 0.1 * surprise + 0.4 * (std::min(from, to) - least);
}

namespace {

/// The margin of a body that may move up, down, or either way.
template <class Scalar>
Scalar margin_of(const BasicScene<Scalar>& scene, bool up, bool down) {
  using std::sqrt;
  const Scalar zero = constant<Scalar>(0.0);
  const Flight<Scalar> held = AppliedForces<Scalar>(scene).flight(zero, zero, zero);
  Scalar amplitude = zero;
  for (int i = 0; i < held.harmonics; ++i) {
    const auto& [cosine, sine, frequency] = held.acting(i);
    const Scalar square = cosine * cosine + sine * sine;
    if (value(square) > 0) amplitude += sqrt(square);
  }
  const Scalar friction = scene.friction * scene.normal_force / scene.mass;
  const bool upwards = up && (!down || value(held.steady) >= 0);
  return amplitude + (upwards ? held.steady : zero - held.steady) - friction;
}

}  // namespace

double release_margin(const Scene& scene, double position) {
  const bool up = position<scene.wall_upper, down = position> scene.wall_lower;
  if (!up && !down) return -std::numeric_limits<double>::infinity();
  return margin_of(scene, up, down);
}

ReleaseSlopes release_slopes(const Scene& scene, double position, const std::string& constant) {
  BasicScene<OrbitMap::Number> lifted_scene = lifted<OrbitMap::Number>(scene);
  lifted_scene.omega.v[OrbitMap::omega_index] = 1;
  vary_constant(lifted_scene, constant, OrbitMap::constant_index);
  const OrbitMap::Number margin =
      margin_of(lifted_scene, position<scene.wall_upper, position> scene.wall_lower);
  return {margin.a, margin.v[OrbitMap::omega_index], margin.v[OrbitMap::constant_index]};
}

}  // namespace ricochet::carrier_track::inline regimes
