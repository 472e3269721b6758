#pragma once

#include <array>
#include <cmath>
#include <limits>

#include "problems/carrier_track/flight.h"
#include "problems/carrier_track/plate_forces.h"

namespace ricochet::carrier_track {

/// The applied forces while the driver plate's speed changes linearly, at one moment.
template <class Scalar>
struct RampForces {
  PlateForces<Scalar> plate;
  Harmonic<Scalar> disturbance;
  Scalar alpha;  ///< [rad]
  Scalar omega;  ///< [rad/s]
  Scalar slope;  ///< of omega [rad/s^2]
};

/// Free motion while the driver plate's speed changes linearly. The forces are then no harmonics,
/// but entire functions of time: their Taylor series, short of rounding, is integrated term by
/// term. So a flight is good for `reach` seconds from where it was made, about a third of a radian,
/// and while the velocity keeps its sign, because it includes friction. The same concept as Flight.
template <class Scalar>
class RampFlight {
 public:
  Scalar position;  ///< [m] now
  Scalar velocity;  ///< [m/s] now

  /// A flight that begins now.
  RampFlight(const Scalar& start_position, const Scalar& start_velocity,
             const RampForces<Scalar>& forces)
      : position(start_position),
        velocity(start_velocity),
        start_position_(start_position),
        start_velocity_(start_velocity) {
    expand(forces);
    acceleration_ = series_[0];
    jerk_ = series_[1];
    snap_ = constant<Scalar>(2) * series_[2];
  }

  /// The plain values of another, for searching events.
  template <class Other>
  explicit RampFlight(const RampFlight<Other>& other)
      : position(value(other.position)),
        velocity(value(other.velocity)),
        start_position_(value(other.start_position_)),
        start_velocity_(value(other.start_velocity_)),
        elapsed_(value(other.elapsed_)),
        acceleration_(value(other.acceleration_)),
        jerk_(value(other.jerk_)),
        snap_(value(other.snap_)),
        reach_(other.reach_),
        size_(other.size_),
        bounds_(other.bounds_) {
    for (std::size_t k = 0; k < terms; ++k) series_[k] = value(other.series_[k]);
  }

  RampFlight<double> plain() const { return RampFlight<double>(*this); }

  /// Exact up to rounding at any t [s] from now, within the reach.
  Motion<Scalar> at(const Scalar& t) const {
    const Scalar time = elapsed_ + t;
    Scalar a = constant<Scalar>(0.0);
    Scalar v = a;
    Scalar x = a;
    for (std::size_t k = terms; k-- > 0;) {
      const auto order = static_cast<double>(k);
      a = a * time + series_[k];
      v = v * time + series_[k] * constant<Scalar>(1 / (order + 1));
      x = x * time + series_[k] * constant<Scalar>(1 / ((order + 1) * (order + 2)));
    }
    return {start_position_ + time * (start_velocity_ + time * x), start_velocity_ + time * v, a};
  }

  /// Moves the origin of the position by -`by` [m].
  void shift(const Scalar& by) {
    position += by;
    start_position_ += by;
  }

  /// The forces at any t [s] within the reach.
  AppliedForce applied_at(double t) const {
    RampFlight<double> there = plain();
    there.advance(t);
    return {there.acceleration(), there.jerk()};
  }

  /// Adds `factor` times the forces of a flight that begins at the same time.
  void add(double factor, const RampFlight& other) {
    const Scalar by = constant<Scalar>(factor);
    for (std::size_t k = 0; k < terms; ++k) series_[k] += by * other.series_[k];
    acceleration_ += by * other.acceleration_;
    jerk_ += by * other.jerk_;
    snap_ += by * other.snap_;
    const double size = std::abs(factor);
    size_ += size * other.size_;
    bounds_.acceleration += size * other.bounds_.acceleration;
    bounds_.jerk += size * other.bounds_.jerk;
    bounds_.snap += size * other.bounds_.snap;
    bounds_.shortest_step = std::fmin(bounds_.shortest_step, other.bounds_.shortest_step);
    reach_ = std::fmin(reach_, other.reach_);
  }

  /// Adds a steady acceleration [m/s^2].
  void push(const Scalar& by) {
    series_[0] += by;
    acceleration_ += by;
    size_ += std::abs(value(by));
    bounds_.acceleration += std::abs(value(by));
  }

  /// Lets `t` [s] pass.
  void advance(const Scalar& t) {
    const Motion<Scalar> m = at(t);
    elapsed_ += t;
    position = m.position;
    velocity = m.velocity;
    acceleration_ = m.acceleration;
    jerk_ = snap_ = constant<Scalar>(0.0);
    for (std::size_t k = terms; k-- > 1;) {
      const auto order = static_cast<double>(k);
      jerk_ = jerk_ * elapsed_ + constant<Scalar>(order) * series_[k];
      if (k > 1) snap_ = snap_ * elapsed_ + constant<Scalar>(order * (order - 1)) * series_[k];
    }
  }

  const Scalar& acceleration() const { return acceleration_; }  ///< [m/s^2]
  const Scalar& jerk() const { return jerk_; }                  ///< [m/s^3]
  const Scalar& snap() const { return snap_; }                  ///< [m/s^4]

  /// See Flight; at the start alone.
  typename Flight<Scalar>::Taylor taylor() const {
    typename Flight<Scalar>::Taylor taylor{{}, reach_ / 15};
    for (std::size_t k = 0; k < taylor.coefficient.size(); ++k) {
      taylor.coefficient[k] = value(series_[k]);
    }
    return taylor;
  }

  /// How long [s] the flight is good for, from where it was made.
  double reach() const { return reach_; }

  /// Sum of the magnitudes that made up the first acceleration [m/s^2].
  double size() const { return size_; }
  /// Bounds over the reach.
  double jerk_bound() const { return bounds_.jerk; }
  const ForceBounds& bounds(double /*until*/) const { return bounds_; }

  /// See Flight; nothing is known here, and a reach is too short for it to matter.
  typename Flight<Scalar>::Speeds speeds(int /*direction*/, double /*time*/) const {
    return {-std::numeric_limits<double>::infinity(), 0};
  }

 private:
  template <class>
  friend class RampFlight;

  /// What is left out at the reach is below 1e-18 of what is there.
  static constexpr std::size_t terms = 16;

  void expand(const RampForces<Scalar>& forces) {
    using std::cos;
    using std::sin;
    const auto& [plate, disturbance, alpha, omega, slope] = forces;
    const Scalar zero = constant<Scalar>(0.0);
    const Scalar two = constant<Scalar>(2.0);
    // omega^2, cos alpha and sin alpha; the latter from (cos alpha)' = -omega sin alpha.
    const std::array<Scalar, 3> square = {omega * omega, two * omega * slope, slope * slope};
    std::array<Scalar, terms> cosine;
    std::array<Scalar, terms> sine;
    cosine[0] = cos(alpha);
    sine[0] = sin(alpha);
    for (std::size_t k = 0; k + 1 < terms; ++k) {
      const Scalar share = constant<Scalar>(1.0 / static_cast<double>(k + 1));
      cosine[k + 1] = -share * (omega * sine[k] + (k > 0 ? slope * sine[k - 1] : zero));
      sine[k + 1] = share * (omega * cosine[k] + (k > 0 ? slope * cosine[k - 1] : zero));
    }
    Scalar even = disturbance.cosine;
    Scalar odd = -disturbance.frequency * disturbance.sine;
    const Scalar turning = disturbance.frequency * disturbance.frequency;
    const Scalar still_cosine = plate.cosine + plate.slope_cosine * slope;
    const Scalar still_sine = plate.sine + plate.slope_sine * slope;
    for (std::size_t k = 0; k < terms; ++k) {
      Scalar turning_cosine = zero;
      Scalar turning_sine = zero;
      for (std::size_t i = 0; i < 3 && i <= k; ++i) {
        turning_cosine += square[i] * cosine[k - i];
        turning_sine += square[i] * sine[k - i];
      }
      series_[k] = still_cosine * cosine[k] + plate.square_cosine * turning_cosine +
                   still_sine * sine[k] + plate.square_sine * turning_sine +
                   (k % 2 == 0 ? even : odd);
      if (k < 3) series_[k] += plate.square * square[k];
      if (k % 2 == 1) {
        const auto order = static_cast<double>(k);
        even = -turning * even * constant<Scalar>(1 / (order * (order + 1)));
        odd = -turning * odd * constant<Scalar>(1 / ((order + 1) * (order + 2)));
      }
    }
    series_[0] += plate.steady;
    bound(forces);
  }

  void bound(const RampForces<Scalar>& forces) {
    const double slope = std::abs(value(forces.slope));
    const double frequency = value(forces.disturbance.frequency);
    const double disturbance =
        std::hypot(value(forces.disturbance.cosine), value(forces.disturbance.sine));
    double omega = value(forces.omega);
    const double fastest =
        std::fmax(std::fmax(omega, disturbance > 0 ? frequency : 0.0), std::sqrt(slope));
    reach_ = fastest > 0 ? 0.3 / fastest : std::numeric_limits<double>::infinity();
    omega += fastest > 0 ? slope * reach_ : 0.0;
    const auto& plate = forces.plate;
    const double steady = std::abs(value(plate.steady));
    const double square = std::abs(value(plate.square));
    const double still = std::hypot(value(plate.cosine), value(plate.sine)) +
                         slope * std::hypot(value(plate.slope_cosine), value(plate.slope_sine));
    const double squared = std::hypot(value(plate.square_cosine), value(plate.square_sine));
    const double turning = still + squared * omega * omega;
    const double turning_rate = 2 * squared * omega * slope;
    size_ = steady + square * omega * omega + turning + disturbance;
    bounds_.acceleration = size_;
    bounds_.jerk =
        2 * square * omega * slope + turning * omega + turning_rate + disturbance * frequency;
    bounds_.snap = 2 * square * slope * slope + turning * (omega * omega + slope) +
                   2 * turning_rate * omega + 2 * squared * slope * slope +
                   disturbance * frequency * frequency;
    bounds_.shortest_step = fastest > 0 ? 1e-8 / fastest : 0.0;
  }

  Scalar start_position_;
  Scalar start_velocity_;
  Scalar elapsed_ = constant<Scalar>(0.0);
  std::array<Scalar, terms> series_;  // of the acceleration, from the start
  Scalar acceleration_;
  Scalar jerk_;
  Scalar snap_;
  double reach_ = 0;
  double size_ = 0;
  ForceBounds bounds_;
};

}  // namespace ricochet::carrier_track
