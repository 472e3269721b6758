#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "problems/carrier_track/motion/flight.h"
#include "problems/carrier_track/motion/forces.h"

namespace ricochet::carrier_track::inline flight {

/// The number of coefficients of a power series in time. With 16 terms the truncation error is
/// below rounding up to a third of a radian.
inline constexpr std::size_t series_terms = 16;
template <class Scalar>
using Series = std::array<Scalar, series_terms>;

/// An acceleration as a series, and its integrals over time t [s]: the position is t^2 times, and
/// the velocity t times, the returned value, so that the start can be added without loss of
/// accuracy.
template <class Scalar, class Time>
Motion<Scalar> integrals(const Series<Scalar>& series, const Time& t) {
  Scalar a = constant<Scalar>(0.0);
  Scalar v = a;
  Scalar x = a;
  for (std::size_t k = series_terms; k-- > 0;) {
    const auto order = static_cast<double>(k);
    a = a * t + series[k];
    v = v * t + scaled(series[k], 1 / (order + 1));
    x = x * t + scaled(series[k], 1 / ((order + 1) * (order + 2)));
  }
  return {x, v, a};
}

/// omega^2, cos alpha and sin alpha, and their products, as series in time while omega, the rate of
/// alpha, changes linearly.
template <class Scalar>
struct RotationTaylor {
  std::array<Scalar, 3> square;  ///< all its coefficients
  Series<Scalar> cosine, sine;
  Series<Scalar> square_cosine, square_sine;

  RotationTaylor(const Scalar& alpha, const Scalar& omega, const Scalar& slope)
      : square{omega * omega, scaled(omega * slope, 2), slope * slope} {
    using std::cos;
    using std::sin;
    const Scalar zero = constant<Scalar>(0.0);
    // From (cos alpha)' = -omega sin alpha.
    cosine[0] = cos(alpha);
    sine[0] = sin(alpha);
    for (std::size_t k = 0; k + 1 < series_terms; ++k) {
      const double share = 1.0 / static_cast<double>(k + 1);
      cosine[k + 1] = scaled(omega * sine[k] + (k > 0 ? slope * sine[k - 1] : zero), -share);
      sine[k + 1] = scaled(omega * cosine[k] + (k > 0 ? slope * cosine[k - 1] : zero), share);
    }
    for (std::size_t k = 0; k < series_terms; ++k) {
      square_cosine[k] = square_sine[k] = zero;
      for (std::size_t i = 0; i < 3 && i <= k; ++i) {
        square_cosine[k] += square[i] * cosine[k - i];
        square_sine[k] += square[i] * sine[k - i];
      }
    }
  }
};

/// Free motion while the driver plate's speed changes linearly. The forces are then entire
/// functions of time, not harmonics. Their Taylor series is integrated term by term; it is
/// truncated below rounding (relative error at the reach below 1e-18). A flight is valid for
/// `reach` seconds from its start, about a third of a radian, and only while the velocity keeps its
/// sign, because it includes friction. The same concept as Flight.
template <class Scalar>
class RampFlight {
 public:
  Scalar position;  ///< [m] now
  Scalar velocity;  ///< [m/s] now

  /// A flight that starts now.
  RampFlight(const Scalar& start_position, const Scalar& start_velocity,
             const RampForces<Scalar>& forces)
      : RampFlight(start_position, start_velocity, forces,
                   {forces.alpha, forces.omega, forces.slope}) {}

  /// The same, with the plate's series given by the caller, who uses them elsewhere too.
  RampFlight(const Scalar& start_position, const Scalar& start_velocity,
             const RampForces<Scalar>& forces, const RotationTaylor<Scalar>& turning)
      : position(start_position),
        velocity(start_velocity),
        start_position_(start_position),
        start_velocity_(start_velocity),
        bounds_(bounds_of(forces)) {
    expand(forces, turning);
    acceleration_ = series_[0];
    jerk_ = series_[1];
    snap_ = scaled(series_[2], 2);
  }

  /// The plain values of another flight, for the search of events.
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
        bounds_(other.bounds_) {
    for (std::size_t k = 0; k < series_terms; ++k) series_[k] = value(other.series_[k]);
  }

  RampFlight<double> plain() const { return RampFlight<double>(*this); }
  /// See Flight.
  RampFlight<double> inner() const requires(DerivativeOrder<Scalar>::value == 1) { return plain(); }

  /// Exact up to rounding at any t [s] from now, within the reach.
  Motion<Scalar> at(const Scalar& t) const {
    const Scalar time = elapsed_ + t;
    const auto [x, v, a] = integrals(series_, time);
    return {start_position_ + time * (start_velocity_ + time * x), start_velocity_ + time * v, a};
  }

  /// Restarts from another position and velocity under the same forces.
  void start(const Scalar& from, const Scalar& with) {
    position = start_position_ = from;
    velocity = start_velocity_ = with;
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
    for (std::size_t k = 0; k < series_terms; ++k) series_[k] += by * other.series_[k];
    acceleration_ += by * other.acceleration_;
    jerk_ += by * other.jerk_;
    snap_ += by * other.snap_;
    const double size = std::abs(factor);
    ForceBounds& bounds = bounds_.forces;
    const ForceBounds& more = other.bounds_.forces;
    bounds_.size += size * other.bounds_.size;
    bounds.acceleration += size * more.acceleration;
    bounds.jerk += size * more.jerk;
    bounds.snap += size * more.snap;
    bounds.shortest_step = std::fmin(bounds.shortest_step, more.shortest_step);
    bounds_.reach = std::fmin(bounds_.reach, other.bounds_.reach);
  }

  /// Adds a steady acceleration [m/s^2].
  void push(const Scalar& by) {
    series_[0] += by;
    acceleration_ += by;
    bounds_.size += std::abs(value(by));
    bounds_.forces.acceleration += std::abs(value(by));
  }

  /// Lets `t` [s] pass.
  void advance(const Scalar& t) {
    const Motion<Scalar> m = at(t);
    elapsed_ += t;
    position = m.position;
    velocity = m.velocity;
    acceleration_ = m.acceleration;
    jerk_ = snap_ = constant<Scalar>(0.0);
    for (std::size_t k = series_terms; k-- > 1;) {
      const auto order = static_cast<double>(k);
      jerk_ = jerk_ * elapsed_ + scaled(series_[k], order);
      if (k > 1) snap_ = snap_ * elapsed_ + scaled(series_[k], order * (order - 1));
    }
  }

  /// See Flight. Changes only position and velocity.
  template <class Tangent>
  void shift_time_derivative(const Tangent& t) requires Dual<Scalar> {
    position.v += t * velocity.a;
    velocity.v += t * acceleration_.a;
  }

  const Scalar& acceleration() const { return acceleration_; }  ///< [m/s^2]
  double plain_acceleration() const { return value(acceleration_); }
  auto inner_acceleration() const requires Dual<Scalar> { return acceleration_.a; }
  const Scalar& jerk() const { return jerk_; }  ///< [m/s^3]
  const Scalar& snap() const { return snap_; }  ///< [m/s^4]

  /// See Flight; valid at the start only.
  typename Flight<Scalar>::Taylor taylor() const {
    typename Flight<Scalar>::Taylor taylor{{}, bounds_.reach / 15};
    for (std::size_t k = 0; k < taylor.coefficient.size(); ++k) {
      taylor.coefficient[k] = value(series_[k]);
    }
    return taylor;
  }

  /// How long [s] the flight is valid, from its start.
  double reach() const { return bounds_.reach; }

  /// Sum of the magnitudes that made up the first acceleration [m/s^2].
  double size() const { return bounds_.size; }
  /// Bounds over the reach.
  double jerk_bound() const { return bounds_.forces.jerk; }
  const ForceBounds& bounds(double /*until*/) const { return bounds_.forces; }

  /// See Flight. Returns no useful bound: a reach is too short for one to matter.
  typename Flight<Scalar>::Speeds speeds(int /*direction*/, double /*time*/) const {
    return {-std::numeric_limits<double>::infinity(), 0};
  }

 private:
  template <class>
  friend class RampFlight;

  void expand(const RampForces<Scalar>& forces, const RotationTaylor<Scalar>& turning) {
    const auto& plate = forces.plate;
    const auto& disturbance = forces.disturbance;
    Scalar even = disturbance.cosine;
    Scalar odd = -disturbance.frequency * disturbance.sine;
    const Scalar rate = disturbance.frequency * disturbance.frequency;
    const Scalar cosine = plate.cosine + plate.slope_cosine * forces.slope;
    const Scalar sine = plate.sine + plate.slope_sine * forces.slope;
    for (std::size_t k = 0; k < series_terms; ++k) {
      series_[k] = cosine * turning.cosine[k] + plate.square_cosine * turning.square_cosine[k] +
                   sine * turning.sine[k] + plate.square_sine * turning.square_sine[k] +
                   (k % 2 == 0 ? even : odd);
      if (k < 3) series_[k] += plate.square * turning.square[k];
      if (k % 2 == 1) {
        const auto order = static_cast<double>(k);
        even = scaled(-rate * even, 1 / (order * (order + 1)));
        odd = scaled(-rate * odd, 1 / ((order + 1) * (order + 2)));
      }
    }
    series_[0] += plate.steady;
  }

  Scalar start_position_;
  Scalar start_velocity_;
  Scalar elapsed_ = constant<Scalar>(0.0);
  Series<Scalar> series_;  // of the acceleration, from the start
  Scalar acceleration_;
  Scalar jerk_;
  Scalar snap_;
  RampBounds bounds_;
};

/// The partial derivatives of the plate's acceleration along a flight with respect to the angle,
/// the speed and the slope of the speed at the start of the flight, as series in time.
///
/// With t the time from the start, f(alpha, omega, slope) the plate's force at any time and F(t)
/// that of this flight:
///   dF/d alpha = df/d alpha,  dF/d omega = t df/d alpha + df/d omega,
///   dF/d slope = t^2 / 2 df/d alpha + t df/d omega + df/d slope.
template <class Scalar>
struct RampPartials {
  Series<Scalar> by_alpha;  ///< [m/s^2 per rad], coefficients of powers of time [s]
  Series<Scalar> by_omega;  ///< [m/s^2 per rad/s]
  Series<Scalar> by_slope;  ///< [m/s^2 per rad/s^2]

  /// `turning` is the series of this speed and slope. Constant is Scalar or double.
  template <class Constant>
  RampPartials(const PlateForces<Constant>& plate, const Scalar& omega, const Scalar& slope,
               const RotationTaylor<Scalar>& turning) {
    const Scalar cosine = plate.cosine + plate.slope_cosine * slope;
    const Scalar sine = plate.sine + plate.slope_sine * slope;
    Scalar by_omega_before = constant<Scalar>(0.0);
    Scalar growth_before = by_omega_before;
    for (std::size_t k = 0; k < series_terms; ++k) {
      // df/d omega is 2 omega times this.
      Scalar growth = plate.square_cosine * turning.cosine[k] + plate.square_sine * turning.sine[k];
      if (k == 0) growth += plate.square;
      Scalar along = omega * growth;
      if (k > 0) along += slope * growth_before;
      along = scaled(along, 2);
      by_alpha[k] = sine * turning.cosine[k] + plate.square_sine * turning.square_cosine[k] -
                    cosine * turning.sine[k] - plate.square_cosine * turning.square_sine[k];
      by_omega[k] = along;
      by_slope[k] = plate.slope_cosine * turning.cosine[k] + plate.slope_sine * turning.sine[k];
      if (k > 0) {
        by_omega[k] += by_alpha[k - 1];
        by_slope[k] += by_omega_before;
      }
      if (k > 1) by_slope[k] += scaled(by_alpha[k - 2], 0.5);
      by_omega_before = along;
      growth_before = growth;
    }
  }
};

/// The RampFlight of a dual scalar, without power series of duals. The flight and its partial
/// derivatives with respect to the few quantities that define it are series in the arithmetic of
/// `Inner`, which is double or a dual of one order less. An evaluation multiplies each partial
/// derivative by the derivatives of its quantity (chain rule).
template <Dual Scalar>
class DualRampFlight {
  using Real = Inner<Scalar>;
  using Tangent = decltype(Scalar::v);
  using Turning = RotationTaylor<Real>;

 public:
  Scalar position;  ///< [m] now
  Scalar velocity;  ///< [m/s] now

  /// A flight that starts now.
  DualRampFlight(const Scalar& start_position, const Scalar& start_velocity,
                 const RampForces<Scalar>& forces)
      : DualRampFlight(start_position, start_velocity, forces,
                       Turning(forces.alpha.a, forces.omega.a, forces.slope.a)) {}

  RampFlight<double> plain() const { return flight_.plain(); }

  const RampFlight<Inner<Scalar>>& inner() const { return flight_; }  ///< see Flight

  /// Exact up to rounding at any t [s] from now, within the reach.
  Motion<Scalar> at(const Scalar& t) const {
    DualRampFlight there = *this;
    there.advance(t);
    return {there.position, there.velocity, there.acceleration()};
  }

  /// Restarts from another position and velocity under the same forces.
  void start(const Scalar& from, const Scalar& with) {
    position = from;
    velocity = with;
    start_position_ = from.v;
    start_velocity_ = with.v;
    flight_.start(from.a, with.a);
  }

  /// Moves the origin of the position by -`by` [m].
  void shift(const Scalar& by) {
    position += by;
    start_position_ += by.v;
    flight_.shift(by.a);
  }

  /// Adds a steady acceleration [m/s^2].
  void push(const Scalar& by) {
    steady_ += by.v;
    flight_.push(by.a);
  }

  /// Lets `t` [s] pass.
  void advance(const Scalar& t) {
    flight_.advance(t.a);
    elapsed_ += t;
    const Real& time = elapsed_.a;
    const Real half = scaled(time * time, 0.5);
    position.a = flight_.position;
    velocity.a = flight_.velocity;
    position.v = start_position_ + start_velocity_ * time + steady_ * half;
    velocity.v = start_velocity_ + steady_ * time;
    for_each_partial([&](const Series<Real>& partial, const Tangent& tangent) {
      const Motion<Real> by = integrals(partial, time);
      position.v += tangent * (time * time * by.position);
      velocity.v += tangent * (time * by.velocity);
    });
    if (disturbance_) {
      const Swung<Scalar> by = swung(*disturbance_, Scalar(time));
      position.v += by.position.v;
      velocity.v += by.velocity.v;
    }
    if (!is_constant(elapsed_)) shift_time_derivative(elapsed_.v);
  }

  /// See Flight. Changes only position and velocity.
  void shift_time_derivative(const Tangent& t) {
    position.v += t * velocity.a;
    velocity.v += t * flight_.acceleration();
  }

  /// The second derivative of the position [m/s^2] now.
  Scalar acceleration() const {
    const Real& time = elapsed_.a;
    Scalar sum(flight_.acceleration());
    sum.v = steady_ + elapsed_.v * flight_.jerk();
    for_each_partial([&](const Series<Real>& partial, const Tangent& tangent) {
      sum.v += tangent * integrals(partial, time).acceleration;
    });
    if (disturbance_) sum.v += swung(*disturbance_, Scalar(time)).cosine.v;
    return sum;
  }

  double plain_acceleration() const { return value(flight_.acceleration()); }
  const Real& inner_acceleration() const { return flight_.acceleration(); }
  Scalar jerk() const {
    return Scalar(flight_.jerk());
  }  ///< [m/s^3], without the outermost derivatives

  double reach() const { return flight_.reach(); }            ///< see RampFlight
  double size() const { return flight_.size(); }              ///< see RampFlight
  double jerk_bound() const { return flight_.jerk_bound(); }  ///< see RampFlight

 private:
  /// The derivatives of the plate's forces themselves, except those of the slope.
  struct Plate {
    Turning turning;
    Tangent steady, square, cosine, square_cosine, sine, square_sine;

    Plate(const RampForces<Scalar>& forces, const Turning& series) : turning(series) {
      const auto& plate = forces.plate;
      const Real& slope = forces.slope.a;
      steady = plate.steady.v;
      square = plate.square.v;
      cosine = plate.cosine.v + plate.slope_cosine.v * slope;
      square_cosine = plate.square_cosine.v;
      sine = plate.sine.v + plate.slope_sine.v * slope;
      square_sine = plate.square_sine.v;
    }
  };

  DualRampFlight(const Scalar& start_position, const Scalar& start_velocity,
                 const RampForces<Scalar>& forces, const Turning& turning)
      : position(start_position),
        velocity(start_velocity),
        start_position_(start_position.v),
        start_velocity_(start_velocity.v),
        alpha_(forces.alpha.v),
        omega_(forces.omega.v),
        slope_(forces.slope.v),
        flight_(start_position.a, start_velocity.a, inner(forces), turning),
        partials_(inner(forces).plate, forces.omega.a, forces.slope.a, turning) {
    if (varies(forces.plate)) plate_.emplace(forces, turning);
    const auto& disturbance = forces.disturbance;
    if (!vanishes(disturbance.cosine) || !vanishes(disturbance.sine)) disturbance_ = disturbance;
  }

  static RampForces<Real> inner(const RampForces<Scalar>& forces) {
    const auto& [plate, disturbance, alpha, omega, slope] = forces;
    return {{plate.steady.a, plate.square.a, plate.cosine.a, plate.square_cosine.a,
             plate.slope_cosine.a, plate.sine.a, plate.square_sine.a, plate.slope_sine.a},
            {disturbance.cosine.a, disturbance.sine.a, disturbance.frequency.a},
            alpha.a,
            omega.a,
            slope.a};
  }

  static bool varies(const PlateForces<Scalar>& plate) {
    for (const Scalar* part :
         {&plate.steady, &plate.square, &plate.cosine, &plate.square_cosine, &plate.slope_cosine,
          &plate.sine, &plate.square_sine, &plate.slope_sine}) {
      if (!is_constant(*part)) return true;
    }
    return false;
  }

  /// Calls `use` with the derivatives of every quantity and the series of the acceleration's
  /// partial derivative with respect to it.
  template <class Use>
  void for_each_partial(Use use) const {
    use(partials_.by_alpha, alpha_);
    use(partials_.by_omega, omega_);
    use(partials_.by_slope, slope_);
    if (!plate_) return;
    Series<Real> one;
    Series<Real> square;
    one.fill(constant<Real>(0.0));
    square.fill(constant<Real>(0.0));
    one[0] = constant<Real>(1.0);
    for (std::size_t k = 0; k < 3; ++k) square[k] = plate_->turning.square[k];
    use(one, plate_->steady);
    use(square, plate_->square);
    use(plate_->turning.cosine, plate_->cosine);
    use(plate_->turning.square_cosine, plate_->square_cosine);
    use(plate_->turning.sine, plate_->sine);
    use(plate_->turning.square_sine, plate_->square_sine);
  }

  Tangent start_position_, start_velocity_;
  Tangent steady_ = constant<Scalar>(0.0).v;  // what was pushed
  Tangent alpha_, omega_, slope_;
  RampFlight<Real> flight_;
  RampPartials<Real> partials_;
  std::optional<Plate> plate_;
  std::optional<Harmonic<Scalar>> disturbance_;
  Scalar elapsed_ = constant<Scalar>(0.0);
};

}  // namespace ricochet::carrier_track::inline flight
