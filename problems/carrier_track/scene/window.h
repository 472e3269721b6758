#pragma once

#include <cmath>
#include <numbers>
#include <variant>
#include <vector>

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline scene {

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

}  // namespace ricochet::carrier_track::inline scene
