#pragma once

#include <cmath>
#include <concepts>
#include <numbers>
#include <optional>
#include <variant>
#include <vector>

#include "problems/carrier_track/scene/scene_fields.h"
#include "ricochet/scene.h"

/// A scene with all its constants as dual numbers.
namespace ricochet::carrier_track::inline scene {

/// Copies a field of a scene into a scene of another scalar type.
struct LiftField {
  template <class From, class To>
  void operator()(const SceneField& /*field*/, const From& from, To& to) const {
    if constexpr (std::same_as<From, To>) {
      to = from;
    } else {
      to = constant<To>(from);
    }
  }
  template <class To>
  void operator()(const SceneField& field, Walls<const double> from, Walls<To> to) const {
    (*this)(field, from.lower, to.lower);
    (*this)(field, from.upper, to.upper);
  }
  template <class To, class From, class Lifted>
  void operator()(const SceneField& field, PlateSpeed<const double, From> from,
                  PlateSpeed<To, Lifted> to) const {
    (*this)(field, from.omega, to.omega);
    for (const auto& knot : from.profile) {
      to.profile.push_back({knot.time, constant<To>(knot.omega)});
    }
  }
};

/// The same scene with every constant as a Scalar, for instance a dual number.
template <class Scalar>
BasicScene<Scalar> lifted(const Scene& scene) {
  BasicScene<Scalar> result;
  visit_flat_fields(LiftField{}, scene, result);
  result.window = scene.window;
  if (scene.across) visit_across_fields(LiftField{}, *scene.across, result.across.emplace());
  return result;
}

/// The time [s] in which the driver plate turns by an angle [rad] > 0 under a speed profile. The
/// last speed of the profile must be > 0.
template <class Scalar>
Scalar time_to_turn(const std::vector<SpeedKnot<Scalar>>& profile, Scalar angle) {
  using std::sqrt;
  const Scalar two = constant<Scalar>(2.0);
  const Scalar first = constant<Scalar>(profile.front().time) * profile.front().omega;
  if (value(first) >= value(angle)) return angle / profile.front().omega;
  angle -= first;
  for (std::size_t k = 1; k < profile.size(); ++k) {
    const auto& [start, omega] = profile[k - 1];
    const Scalar span = constant<Scalar>(profile[k].time - start);
    const Scalar rise = profile[k].omega - omega;
    const Scalar leg = span * (omega + rise / two);
    if (value(leg) >= value(angle)) {
      const Scalar slope = rise / span;
      const Scalar end = sqrt(omega * omega + two * slope * angle);
      return constant<Scalar>(start) + two * angle / (omega + end);
    }
    angle -= leg;
  }
  return constant<Scalar>(profile.back().time) + angle / profile.back().omega;
}

/// The duration of a scene's window [s]. A window in revolutions needs omega > 0.
template <class Scalar>
Scalar duration_of(const BasicScene<Scalar>& scene) {
  const auto* turns = std::get_if<Revolutions>(&scene.window);
  if (turns == nullptr) return constant<Scalar>(std::get<Seconds>(scene.window).count);
  const Scalar angle = constant<Scalar>(2 * std::numbers::pi * turns->count);
  return scene.profile.empty() ? angle / scene.omega : time_to_turn(scene.profile, angle);
}

/// Revolutions of the driver plate in the window of a scene at its constant speed.
inline double turns_of(const Scene& scene) {
  return scene.omega * duration_of(scene) / (2 * std::numbers::pi);
}

// What the forces of a scene can do to a carrier that rests on a wall: estimates by hand formulas,
// for constant speeds of the plate.

/// The applied force along x at a constant speed, without friction [N]: it swings about a steady
/// part, which presses the carrier on a wall.
struct AppliedForce {
  double steady;  ///< size of the part that does not change
  double swing;   ///< amplitude of the rest; the disturbance adds to it with its whole amplitude
};
AppliedForce applied_force(const Scene& scene, double omega);

/// The speed of the plate [rad/s] from which the force takes the carrier off the wall on which the
/// steady part presses it: swing = steady + friction normal_force. Impacts begin a little later,
/// where it reaches the other wall, or comes back with some speed. Without pull, slider and
/// disturbance this is sqrt(friction normal_force / centrifugal_mass_radius). 0 if every speed
/// does; nothing if no speed up to 1000 rad/s does.
std::optional<double> release_speed(const Scene& scene);

/// The speed [m/s] that the largest applied force at a constant speed of the plate, less friction,
/// gives the carrier across the clearance: sqrt(2 force clearance / mass). 0 if friction holds it;
/// infinite without an upper wall.
double thrown_speed(const Scene& scene, double omega);

/// The scene with its clearance multiplied by a factor > 0. The lower wall stays; the start stays
/// at the same share of the clearance.
template <class Scalar>
BasicScene<Scalar> scaled_clearance(const Scalar& factor, BasicScene<Scalar> scene) {
  scene.wall_upper = scene.wall_lower + factor * (scene.wall_upper - scene.wall_lower);
  scene.start_position = scene.wall_lower + factor * (scene.start_position - scene.wall_lower);
  return scene;
}

/// The largest relative change of a constant in a perturbed scene, in the tenth digit: about a
/// million times the rounding error.
inline constexpr double perturbation_size = 1e-9;

/// A valid scene with all its constants changed at once, each up or down by 0.5 to 1 times
/// perturbation_size. `stride`, an irrational number within 0..1, sets the pattern of amounts and
/// signs; `sign`, 1 or -1, multiplies all changes. The amounts are drawn in the order of the list
/// of fields, so a new field in the list changes the amounts of all later fields.
///
/// Unchanged are zeros, the exponent of a contact, the limits of the rule and the window. A
/// restitution never rises above 1, and a body that starts on a wall still does. Lengths change by
/// a share of the largest coordinate, angles by a share of the angle or of one radian, whichever is
/// larger.
Scene perturbed(Scene scene, double stride, double sign);

}  // namespace ricochet::carrier_track::inline scene
