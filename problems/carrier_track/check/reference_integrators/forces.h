#pragma once

#include <cmath>
#include <vector>

// NOTE: plain C++17, like flight_method.h and dense_flight.h: Boost.Odeint's rosenbrock4 does not
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

}  // namespace ricochet::carrier_track::inline reference_integrators
