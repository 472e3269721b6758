#pragma once

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/scene/contact_restitution.h"
#include "ricochet/recording.h"

namespace ricochet::carrier_track::inline counting {

/// Smoothing parameter of the fading at the end of the window, where an impact would otherwise
/// leave with all its energy.
inline constexpr double wear_smoothing = 0.25;

/// mass (1 - restitution^2) / 2, with a wall's restitution reduced by contact friction: times the
/// square of the approach speed it is the energy [J] that an impact on that wall dissipates.
template <class Scalar>
Scalar impact_loss(const BasicScene<Scalar>& scene, Wall wall) {
  const Scalar restitution =
      wall == Wall::lower ? lower_restitution(scene) : upper_restitution(scene);
  const Scalar half = constant<Scalar>(0.5);
  return half * scene.mass * (constant<Scalar>(1.0) - restitution * restitution);
}

/// Sums the kinetic energy that impacts dissipate.
template <class Scalar>
class EnergyLost : public Observer {
 public:
  explicit EnergyLost(const BasicScene<Scalar>& scene)
      : lower_(impact_loss(scene, Wall::lower)),
        upper_(impact_loss(scene, Wall::upper)),
        duration_(duration_of(scene)) {}

  void impact(const Scalar& time, Wall wall, const Scalar& speed) {
    const Scalar left = constant<Scalar>(1.0) - time / duration_;
    sum_ += fading(left, wear_smoothing) * (wall == Wall::lower ? lower_ : upper_) * speed * speed;
  }

  Scalar total() const { return constant<Scalar>(1e3) * sum_; }  ///< [mJ]

 private:
  Scalar lower_, upper_;
  Scalar duration_;
  Scalar sum_ = constant<Scalar>(0.0);  // [J]
};

/// The wear of a valid scene [mJ]: the energy that all impacts of the window dissipate in track and
/// carrier (wear increases with the work done: Archard, J. Appl. Phys. 24 (1953) 981). It is smooth
/// where the count jumps: a new impact appears with speed 0, or enters at the end of the window,
/// where its weight is 0 (collisions.h). The energy of impacts slower than resting_speed is
/// omitted. `also` observes the simulation too.
template <class Scalar, class Also>
Scalar wear(const BasicScene<Scalar>& scene, Also& also) {
  EnergyLost<Scalar> lost(scene);
  ObserverPair both(lost, also);
  simulate_at_needed_fidelity(scene, both);
  return lost.total();
}

template <class Scalar>
Scalar wear(const BasicScene<Scalar>& scene) {
  Observer nobody;
  return wear(scene, nobody);
}

}  // namespace ricochet::carrier_track::inline counting
