#pragma once

#include <cmath>

#include "ricochet/scene.h"

/// Laws for the force of a compliant wall on a body, with penetration d [m] and its rate d' [m/s]:
///   F = K d^n (1 + D d' / v0)   every law except Kelvin-Voigt,
///   F = K d + C d'              Kelvin-Voigt.
/// D depends on a prescribed restitution c. v0 [m/s] is the speed of approach, either of each
/// impact or the same for all. F is zero where the contact begins and ends, d = 0. In an impact
/// without other forces F never pulls, because d' stays above -v0 / D. If another force pulls the
/// body off the wall faster than that, F holds it back: the law is kept as published. If a body
/// arrives much slower than it is pressed in afterwards, the damping is very strong and the body
/// creeps in and out. Kelvin-Voigt would pull at the end of every contact, so its force is
///   F = max(0, K d + C d').
namespace ricochet::carrier_track::inline scene {

/// Returns true if the damping is unbounded as the restitution approaches 0.
bool needs_restitution(ContactLaw law);

/// D of a law for a prescribed restitution in [0, 1], > 0 if needs_restitution(law). Throws
/// std::invalid_argument outside this range, and for kelvin_voigt: use damping_ratio for it.
double dissipation(ContactLaw law, double restitution);

/// The restitution that an impact without other forces returns for D >= 0: the root e of
/// D (1 + e) = ln((1 + D) / (1 - e D)), whatever K, m, n and v0; relative error about 1e-15. Of the
/// published D only the exact one returns the restitution that it is computed from. Derivation:
/// divide m d'' = -F by d^n and integrate over d.
double returned_restitution(double dissipation);

/// Deepest penetration [m] of an impact without other forces:
/// d^(n+1) = (n + 1) (m / K) v0^2 (D - ln(1 + D)) / D^2, with mass m [kg], stiffness K [N/m^n].
double peak_penetration(double stiffness, double exponent, double mass, double speed,
                        double dissipation);

/// The end of a Kelvin-Voigt contact.
enum class Release {
  zero_force,  ///< when the force would become negative
  zero_depth   ///< when the depth is back to zero
};

/// The restitution that Kelvin-Voigt returns without other forces for a damping ratio
/// z = C / (2 sqrt(K m)) >= 0. With s = sqrt(1 - z^2):
/// zero_force: exp(-2 z acos(z) / s), for z > 1 exp(-2 z acosh(z) / sqrt(z^2 - 1));
/// zero_depth: exp(-pi z / s), 0 for z >= 1.
double kelvin_voigt_restitution(double damping_ratio, Release release);

/// The damping ratio that returns a restitution in (0, 1]; throws std::invalid_argument outside.
double damping_ratio(double restitution, Release release);

/// D of a law for a restitution; for kelvin_voigt the damping ratio that returns the restitution
/// when the wall never pulls. Throws as dissipation and damping_ratio do.
double damping_factor(ContactLaw law, double restitution);

// The restitution of a wall, with the loss by contact friction.

/// The factor by which contact friction reduces a wall's restitution, see BasicScene.
template <class Scalar>
Scalar returned_share(const BasicScene<Scalar>& scene) {
  using std::sqrt;
  const Scalar one = constant<Scalar>(1.0);
  if (!scene.contact_friction) return one;
  // The derivative with respect to this friction is infinite; it is set to 0.
  if (value(scene.friction) >= 1) return constant<Scalar>(0.0);
  return sqrt((one - scene.friction) / (one + scene.friction));
}

template <class Scalar>
Scalar lower_restitution(const BasicScene<Scalar>& scene) {
  return scene.restitution_lower * returned_share(scene);
}

template <class Scalar>
Scalar upper_restitution(const BasicScene<Scalar>& scene) {
  return scene.restitution_upper * returned_share(scene);
}

}  // namespace ricochet::carrier_track::inline scene
