#pragma once

#include <concepts>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// Traits of a scalar that may be a dual number: its plain value, its derivatives, and how deeply
/// duals are nested. A dual is any type like ceres::Jet, with a real part `a` and DIMENSION
/// derivatives `v`, all of one type.
namespace ricochet::carrier_track::inline scene {

template <class T>
concept Dual = requires(T x) {
  x.a;
  x.v;
};

/// The type of a dual's real part: double, or a dual of one order less.
template <Dual T>
using Inner = decltype(T::a);

template <std::floating_point T>
double value(T x) {
  return static_cast<double>(x);
}

template <Dual T>
double value(const T& x) {
  return value(x.a);
}

/// 0 for double, 1 for a dual, 2 for a dual of duals: the order of the derivatives carried.
template <class T>
struct DerivativeOrder {
  static constexpr int value = 0;
};

template <Dual T>
struct DerivativeOrder<T> {
  static constexpr int value = 1 + DerivativeOrder<Inner<T>>::value;
};

/// Number of Newton steps that refine an event time found in double to the accuracy of T: one for
/// each order of derivatives, and two for a type with more digits.
template <class T>
inline constexpr int newton_steps = std::same_as<T, double> ? 0
                                    : Dual<T>               ? DerivativeOrder<T>::value
                                                            : 2;

/// A constant as a scalar of type T; duals of duals cannot be converted from double directly.
template <class T>
T constant(double x) {
  if constexpr (Dual<T>) {
    return T(constant<Inner<T>>(x));
  } else {
    return x;
  }
}

template <class T>
bool is_constant(const T& x);

/// Returns true if x and all its derivatives are zero. A quantity whose value alone is zero still
/// affects derivatives.
template <class T>
bool vanishes(const T& x) {
  if constexpr (Dual<T>) {
    return vanishes(x.a) && is_constant(x);
  } else {
    return x == 0;
  }
}

/// Returns true if x has no derivatives of the outermost order.
template <class T>
bool is_constant(const T& x) {
  if constexpr (Dual<T>) {
    for (int i = 0; i < T::DIMENSION; ++i) {
      if (!vanishes(x.v[i])) return false;
    }
  }
  return true;
}

/// x times a plain number, without the products by zero that a constant of type T costs.
template <class T>
T scaled(const T& x, double by) {
  if constexpr (Dual<T>) {
    T result;
    result.a = scaled(x.a, by);
    for (int i = 0; i < T::DIMENSION; ++i) result.v[i] = scaled(x.v[i], by);
    return result;
  } else {
    return x * by;
  }
}

// @file
// A machine: one yarn carrier in its clearance, and the TOML file that describes it.

/// How the centrifugal force F_a = m r_c omega^2 enters the x axis: equation (31) projects it,
/// while the text of the paper draws it inward.
enum class Centrifugal { projected, inward, outward };

/// The rule that decides which events of the motion count as collisions; see count.h.
enum class CountRule { impacts, peaks };

/// Laws for the force of a compliant wall: D(c) for a prescribed restitution c, see contact_law.h.
enum class ContactLaw {
  hertz,                ///< D = 0
  kelvin_voigt,         ///< n = 1, C from the restitution it returns when it never pulls
  hunt_crossley,        ///< D = 3 (1 - c) / 2
  lankarani_nikravesh,  ///< D = 3 (1 - c^2) / 4
  zhiying_qishao,       ///< D = 3/4 (1 - c^2) exp(2 (1 - c))
  flores,               ///< D = 8 (1 - c) / (5 c)
  gonthier,             ///< D = (1 - c^2) / c, his approximation
  exact_restitution     ///< the D that returns c
};

/// The levels of the model, from the cheapest; automatic is the cheapest whose count is certain.
enum class Fidelity { impact, compliant, planar, automatic };

/// The simulated window: a number of revolutions of the driver plate, or a time.
struct Revolutions {
  double count;  ///< > 0
};
struct Seconds {
  double count;  ///< [s], > 0
};
using Window = std::variant<Revolutions, Seconds>;

/// The speed of the driver plate at a time [s]. Between knots it changes linearly with time; before
/// the first and after the last knot it is constant.
template <class Scalar>
struct SpeedKnot {
  double time;   ///< [s], >= 0, increasing from knot to knot
  Scalar omega;  ///< [rad/s], >= 0
};

/// The second direction, y, of equation (22): the lateral clearance, in which the carrier moves
/// too. Mass and friction coefficient are those of x.
template <class Scalar>
struct Across {
  Scalar pull = constant<Scalar>(0.0);               ///< [N], T_1 sin(phi), towards the upper wall
  Scalar wall_lower = constant<Scalar>(0.0);         ///< [m]
  Scalar wall_upper = constant<Scalar>(1.0);         ///< [m], > wall_lower, may be infinite
  Scalar restitution_lower = constant<Scalar>(1.0);  ///< in [0, 1]
  Scalar restitution_upper = constant<Scalar>(1.0);  ///< in [0, 1]
  Scalar start_position = constant<Scalar>(0.5);     ///< [m], within the walls
  Scalar start_velocity = constant<Scalar>(0.0);     ///< [m/s]
};

/// A yarn carrier in its clearance: equation (31) of the paper along x, which points from the lower
/// to the upper wall. SI units. Physical constants are of type Scalar so that derivatives with
/// respect to any of them can be carried through a simulation.
///
/// mass x'' = - pull (cos(alpha + pull_phase) if pull_rotates, else 1)
///            + centrifugal_mass_radius omega^2 (cos alpha | -1 | +1)
///            - slider_mass_radius (omega' sin alpha + omega^2 cos alpha)
///            + disturbance cos(disturbance_frequency t + disturbance_phase)
///            + contact - friction normal_force sign(x'),
/// where alpha is the integral of omega, plus phase;
/// friction is set-valued at rest, and an impact changes x' to -restitution x'. With
/// contact_friction, a wall's force F causes the friction force friction F on the way in and out:
/// the restitution of the wall is then multiplied by sqrt((1 - friction) / (1 + friction)).
///
/// The defaults describe a body at rest between two elastic walls without forces. A file
/// need not name them.
template <class Scalar>
struct BasicScene {
  Scalar mass = constant<Scalar>(1.0);               ///< [kg], > 0
  Scalar wall_lower = constant<Scalar>(0.0);         ///< [m]
  Scalar wall_upper = constant<Scalar>(1.0);         ///< [m], > wall_lower, may be infinite
  Scalar restitution_lower = constant<Scalar>(1.0);  ///< in [0, 1]
  Scalar restitution_upper = constant<Scalar>(1.0);  ///< in [0, 1]
  Scalar friction = constant<Scalar>(0.0);           ///< Coulomb coefficient, >= 0
  Scalar normal_force =
      constant<Scalar>(0.0);                  ///< [N], >= 0; multiplied by the friction coefficient
  bool contact_friction = false;              ///< whether it also multiplies the wall's force
  Scalar pull = constant<Scalar>(0.0);        ///< [N], T_1 cos(phi), towards the lower wall
  bool pull_rotates = false;                  ///< whether the pull rotates with the driver plate
  Scalar pull_phase = constant<Scalar>(0.0);  ///< [rad], of a pull that rotates, ahead of alpha
  Centrifugal centrifugal = Centrifugal::projected;
  Scalar centrifugal_mass_radius = constant<Scalar>(0.0);  ///< [kg m], m r_c, >= 0
  Scalar slider_mass_radius =
      constant<Scalar>(0.0);                   ///< [kg m], (m_s1 + m_s2) L sin(theta/2), >= 0
  Scalar phase = constant<Scalar>(0.0);        ///< [rad], alpha at t = 0
  Scalar disturbance = constant<Scalar>(0.0);  ///< [N]
  Scalar disturbance_frequency = constant<Scalar>(1.0);  ///< [rad/s], >= 0
  Scalar disturbance_phase = constant<Scalar>(0.0);      ///< [rad]
  Scalar start_position = constant<Scalar>(0.5);         ///< [m], within the walls
  Scalar start_velocity = constant<Scalar>(0.0);         ///< [m/s]
  Scalar omega = constant<Scalar>(1.0);    ///< [rad/s], speed of the driver plate, >= 0
  std::vector<SpeedKnot<Scalar>> profile;  ///< replaces omega if not empty
  Window window = Seconds{1.0};
  CountRule rule = CountRule::impacts;
  Scalar counting_limit =
      constant<Scalar>(1e-3);  ///< [m/s], > 0; rule impacts: slower impacts do not count
  Scalar peak_high = constant<Scalar>(3e-3);  ///< [m], > 0; rule peaks: a maximum above this counts
  Scalar peak_low = constant<Scalar>(1e-3);   ///< [m], > 0; rule peaks: a maximum below this counts
  Fidelity fidelity = Fidelity::impact;
  // For fidelity compliant only, which has no derivatives.
  ContactLaw contact_law = ContactLaw::hunt_crossley;
  double stiffness = 1e8;                ///< [N/m^contact_exponent], > 0
  double contact_exponent = 1.5;         ///< > 0, of compliant walls >= 1; 1 for kelvin_voigt
  std::optional<double> contact_speed;   ///< [m/s], > 0: v0; none: the speed of each impact
  std::optional<Across<Scalar>> across;  ///< for fidelity planar and automatic
};

using Scene = BasicScene<double>;

/// The same scene at a constant speed [rad/s].
template <class Scalar>
BasicScene<Scalar> at_speed(BasicScene<Scalar> scene, const Scalar& omega) {
  scene.omega = omega;
  scene.profile.clear();
  return scene;
}

/// Reads a machine from a TOML file with the tables [scene], [across], [window], [count] and
/// [model] of docs/machine-files.md. Throws InputError, in one line with file, key, value and what
/// is allowed, for a file that cannot be read or parsed, an unknown or missing key, a wrong type,
/// or a value out of range.
Scene read_scene(const std::string& path);

/// The same from a text. Errors name it `origin`.
Scene parse_scene(const std::string& text, const std::string& origin);

/// The scene as a TOML text that read_scene reads back to the same scene, bit for bit.
std::string write_scene(const Scene& scene);

/// Throws InputError, with one line "<origin>: <table.key> = <value>: must be <allowed range>", for
/// the first invalid field of `scene`. `origin` names the scene, for instance its file.
void check(const Scene& scene, const std::string& origin);

}  // namespace ricochet::carrier_track::inline scene
