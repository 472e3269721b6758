#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "problems/carrier_track/flight.h"
#include "problems/carrier_track/scene.h"

namespace ricochet::carrier_track {

/// Equation (31) but for contact and friction, divided by the mass: a steady acceleration and two
/// harmonics, of the driver plate and of the disturbance, as they are at the present time.
template <class Scalar>
class AppliedForces {
 public:
  explicit AppliedForces(const BasicScene<Scalar>& scene) {
    using std::cos;
    using std::sin;
    const Scalar zero = constant<Scalar>(0.0);
    const Scalar centrifugal = scene.centrifugal_mass_radius * scene.omega * scene.omega;
    Scalar turning = -scene.slider_mass_radius * scene.omega * scene.omega;
    Scalar steady = zero;
    (scene.pull_rotates ? turning : steady) -= scene.pull;
    switch (scene.centrifugal) {
      case Centrifugal::projected:
        turning += centrifugal;
        break;
      case Centrifugal::inward:
        steady -= centrifugal;
        break;
      case Centrifugal::outward:
        steady += centrifugal;
        break;
    }
    steady_ = steady / scene.mass;
    const Scalar amplitude = turning / scene.mass;
    harmonic_[0] = {amplitude * cos(scene.phase), amplitude * sin(scene.phase), scene.omega};
    harmonic_[1] = {scene.disturbance / scene.mass, zero, scene.disturbance_frequency};
    harmonics_ = value(scene.disturbance) == 0.0 ? 1 : 2;
  }

  /// The same of equation (22), for the second direction, y; `scene` must have one. It has no
  /// disturbance, and sin alpha is the cosine of an angle a quarter turn behind.
  static AppliedForces across(const BasicScene<Scalar>& scene) {
    using std::cos;
    using std::sin;
    const Scalar zero = constant<Scalar>(0.0);
    Scalar turning = scene.slider_mass_radius * scene.omega * scene.omega;
    if (scene.pull_rotates) turning += scene.pull;
    const Scalar amplitude = turning / scene.mass;
    AppliedForces forces(scene);
    forces.steady_ = scene.across.value().pull / scene.mass;
    forces.harmonic_[0] = {amplitude * sin(scene.phase), -amplitude * cos(scene.phase),
                           scene.omega};
    forces.harmonic_[1] = {zero, zero, scene.disturbance_frequency};
    forces.harmonics_ = 1;
    return forces;
  }

  const Scalar& steady() const { return steady_; }
  const std::array<Harmonic<Scalar>, 2>& harmonic() const { return harmonic_; }

  /// The acceleration now [m/s^2].
  Scalar sum() const {
    Scalar sum = steady_;
    for (int i = 0; i < harmonics_; ++i) sum += at(i).cosine;
    return sum;
  }

  /// Sum of the magnitudes that make up sum() [m/s^2]: what its rounding is relative to.
  double size() const {
    double size = std::abs(value(steady_));
    for (int i = 0; i < harmonics_; ++i) size += std::abs(value(at(i).cosine));
    return size;
  }

  /// Bound over all time on the rate of sum() [m/s^3].
  double jerk_bound() const {
    double bound = 0;
    for (int i = 0; i < harmonics_; ++i) {
      bound += std::hypot(value(at(i).cosine), value(at(i).sine)) * value(at(i).frequency);
    }
    return bound;
  }

  /// Free flight from here under these forces and a further steady acceleration, of friction.
  Flight<Scalar> flight(const Scalar& position, const Scalar& velocity,
                        const Scalar& further) const {
    return {position, velocity, steady_ + further, harmonic_, harmonics_};
  }

  /// Lets `time` [s] pass. The angles are turned, not kept: they keep their amplitude, and none
  /// grows without bound.
  void pass(const Scalar& time) {
    const Scalar zero = constant<Scalar>(0.0);
    fly(flight(zero, zero, zero), time);
  }

  /// Lets the time of a flight pass: returns where it ends.
  Motion<Scalar> fly(const Flight<Scalar>& flight, const Scalar& time) {
    return flight.at(time, &harmonic_);
  }

 private:
  const Harmonic<Scalar>& at(int i) const { return harmonic_[static_cast<std::size_t>(i)]; }

  Scalar steady_;
  std::array<Harmonic<Scalar>, 2> harmonic_;
  int harmonics_;
};

}  // namespace ricochet::carrier_track
