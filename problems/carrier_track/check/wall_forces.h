#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

// NOTE: plain C++17, like integrator.h and integrator.h: Boost.Odeint's rosenbrock4 does not
// compile as C++20, and scene.h needs concepts.
namespace ricochet::carrier_track::inline scene {

template <class Scalar>
struct BasicScene;

}  // namespace ricochet::carrier_track::inline scene

namespace ricochet::carrier_track::inline reference_integrators {

struct State {
  double position;  ///< [m]
  double velocity;  ///< [m/s]
};

/// The forces of the driver plate with a speed profile, and the plate's angle from knot to knot.
struct ProfilePlate {
  struct Knot {
    double time, alpha, omega;
  };
  std::vector<Knot> knots;
  double steady = 0;         // [m/s^2]
  double square = 0;         // [m], times omega^2
  double cosine = 0;         // [m/s^2], times cos(alpha)
  double square_cosine = 0;  // [m], times omega^2 cos(alpha)
  double sine = 0;           // [m/s^2], times sin(alpha)
  double slider = 0;         // [m], times -omega' sin(alpha)

  double applied(double time) const;
  double applied_rate(double time) const;
  double strongest() const;

 private:
  struct Plate {
    double alpha, omega, slope;
  };
  Plate plate(double time) const;
};

/// The right-hand side of equation (31) between impacts, as accelerations [m/s^2].
struct Forces {
  double steady = 0;
  double turning = 0;  ///< amplitude, with angle omega t + phase
  double omega = 0;    ///< [rad/s]
  double phase = 0;    ///< [rad]
  double disturbance = 0;
  double disturbance_frequency = 0;  ///< [rad/s]
  double disturbance_phase = 0;      ///< [rad]
  double friction = 0;               ///< >= 0, set-valued at rest
  ProfilePlate profile;              ///< replaces steady and turning if it has knots

  /// All forces except contact and friction, at `time` [s].
  double applied(double time) const {
    double sum = profile.knots.empty() ? steady : profile.applied(time);
    if (turning != 0) sum += turning * std::cos(omega * time + phase);
    if (disturbance != 0)
      sum += disturbance * std::cos(disturbance_frequency * time + disturbance_phase);
    return sum;
  }

  /// Its derivative with respect to time [m/s^3].
  double applied_rate(double time) const {
    return (profile.knots.empty() ? 0.0 : profile.applied_rate(time)) -
           turning * omega * std::sin(omega * time + phase) -
           disturbance * disturbance_frequency *
               std::sin(disturbance_frequency * time + disturbance_phase);
  }

  /// Bound on the magnitude of applied() [m/s^2].
  double strongest() const;

  /// [s]; of the time-dependent forces, infinite if there are none.
  double shortest_period() const;
};

/// The forces of a valid scene.
Forces forces_of(const BasicScene<double>& scene);

// NOTE: plain C++17, like forces.h.

/// The force of two compliant walls divided by the mass [m/s^2], as a function of the state: the
/// laws of contact_law.h, without events.
struct WallForce {
  struct Slopes {
    double by_position;  ///< [1/s^2]
    double by_velocity;  ///< [1/s]
  };

  double lower = 0, upper = 0;                  ///< [m], the walls; upper may be infinite
  double stiffness = 0;                         ///< K/m
  double exponent = 1;                          ///< n
  bool viscous = false;                         ///< Kelvin-Voigt
  double lower_damping = 0, upper_damping = 0;  ///< D, or C/m [1/s] if viscous
  double speed = 1;                             ///< [m/s], v0 of the law

  /// Penetration [m], <= 0 between the walls.
  double depth(double position) const { return std::max(lower - position, position - upper); }

  double operator()(const State& state) const {
    const double d = depth(state.position);
    if (!(d > 0)) return 0;
    const int outward = state.position < lower ? +1 : -1;
    const double rate = -outward * state.velocity;
    if (viscous) return outward * std::max(0.0, stiffness * d + damping(outward) * rate);
    return outward * spring(d) * (1 + damping(outward) / speed * rate);
  }

  Slopes slopes(const State& state) const {
    const double d = depth(state.position);
    if (!(d > 0)) return {0, 0};
    const int outward = state.position < lower ? +1 : -1;
    const double rate = -outward * state.velocity;
    if (viscous) {
      const bool presses = stiffness * d + damping(outward) * rate > 0;
      return presses ? Slopes{-stiffness, -damping(outward)} : Slopes{0, 0};
    }
    const double factor = damping(outward) / speed;
    return {-exponent * spring(d) / d * (1 + factor * rate), -factor * spring(d)};
  }

 private:
  double damping(int outward) const { return outward > 0 ? lower_damping : upper_damping; }

  double spring(double d) const {
    if (exponent == 1.5) return stiffness * d * std::sqrt(d);
    return exponent == 1 ? stiffness * d : stiffness * std::pow(d, exponent);
  }
};

/// The walls of a valid scene with compliant walls; `speed` is its contact_speed, or 1 m/s.
WallForce wall_force_of(const BasicScene<double>& scene);

}  // namespace ricochet::carrier_track::inline reference_integrators
