#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "problems/carrier_track/flight/plate_ramp.h"
#include "problems/carrier_track/gradients/event_terms.h"
#include "problems/carrier_track/gradients/leg_record.h"
#include "problems/carrier_track/gradients/linear_leg.h"

namespace ricochet::carrier_track::inline gradients {

/// A motion under a speed profile as legs, each of which lies between two knots.
class ProfileMotion {
 public:
  /// `scene` must be valid, of fidelity impact, its window in seconds, with at least two knots, the
  /// first at time 0 and the last at the window's end.
  ProfileMotion(const Scene& scene, std::vector<MotionLeg> legs);

  std::size_t size() const { return legs_.size(); }
  const MotionLeg& leg(std::size_t i) const { return legs_[i]; }
  /// Returns true if a flight follows leg i.
  bool flies_on(std::size_t i) const { return i + 1 < legs_.size() && !legs_[i + 1].rests; }
  /// Returns true if leg i begins a flight after a rest.
  bool released(std::size_t i) const { return i > 0 && legs_[i - 1].rests && !legs_[i].rests; }
  /// Returns true if leg i starts at a time that depends on the motion before, not at a cut.
  bool start_moves(std::size_t i) const {
    return i > 0 && (legs_[i - 1].rests || legs_[i - 1].end != LegEnd::cut);
  }

  std::size_t knots() const { return times_.size(); }
  double time(std::size_t knot) const { return times_[knot]; }  ///< [s]
  /// The time from a knot to the next [s].
  double span(std::size_t knot) const { return times_[knot + 1] - times_[knot]; }
  /// The knot before leg i.
  std::size_t knot_before(std::size_t i) const { return before_[i]; }

  double restitution(std::size_t i) const { return restitution_[legs_[i].direction > 0]; }

  /// The plate at every knot but the last, if the knots have these speeds [rad/s].
  template <class Scalar>
  std::vector<PlateRamp<Scalar>> ramps(std::span<const Scalar> speeds) const {
    std::vector<PlateRamp<Scalar>> ramps;
    PlateRamp<Scalar> ramp{Scalar(phase_)};
    for (std::size_t k = 0; k + 1 < knots(); ++k) {
      ramp.speed = speeds[k];
      ramp.slope = (speeds[k + 1] - speeds[k]) * (1 / span(k));
      ramps.push_back(ramp);
      ramp = ramp.after(span(k));
    }
    return ramps;
  }
  const std::vector<PlateRamp<double>>& ramps() const { return ramps_; }
  /// The plate at the start of leg i.
  PlateRamp<double> ramp(std::size_t i) const {
    return ramps_[before_[i]].after(legs_[i].start - times_[before_[i]]);
  }
  double speed(std::size_t knot) const { return speeds_[knot]; }  ///< [rad/s]

  /// The acceleration [m/s^2] of leg i, a flight, at a time [s].
  template <class Scalar>
  Scalar acceleration(std::size_t i, const Scalar& time, const PlateRamp<Scalar>& ramp) const {
    Scalar sum = acceleration_of(plate_, ramp) - legs_[i].direction * friction_;
    if (disturbance_.cosine != 0 || disturbance_.sine != 0) sum += after(disturbance_, time).cosine;
    return sum;
  }

  /// The response of leg i, a flight that starts at `ramp`.
  template <class Scalar>
  LegResponse<Scalar> response(std::size_t i, const Scalar& start,
                               const PlateRamp<Scalar>& ramp) const {
    return response_of(plate_, disturbance_, start, ramp, legs_[i].duration);
  }

  /// The derivatives of the start of leg i, the release of a body at rest, with respect to the ramp
  /// there. A force that jumps out of the band of friction, at a knot, does so at a fixed time.
  PlateRamp<double> release(std::size_t i) const;

 private:
  PlateForces<double> plate_;
  Harmonic<double> disturbance_;
  double friction_;  // [m/s^2]
  double restitution_[2];
  double phase_;
  std::vector<double> times_, speeds_;  // of the knots
  std::vector<PlateRamp<double>> ramps_;
  std::vector<MotionLeg> legs_;
  std::vector<std::size_t> before_;
};

/// Completes legs of which all is known but ramp, acceleration and response. `ramps` has the plate
/// at the knots; `respond(i)` returns the response of leg i, with its ramp. Rests stay empty.
template <class Scalar, class Respond>
void complete(const ProfileMotion& motion, const std::vector<PlateRamp<Scalar>>& ramps,
              std::vector<LinearLeg<Scalar>>& legs, const Respond& respond) {
  for (std::size_t i = 0; i < motion.size(); ++i) {
    if (motion.leg(i).rests) continue;
    LinearLeg<Scalar>& leg = legs[i];
    const std::size_t knot = motion.knot_before(i);
    leg.ramp = ramps[knot].after(leg.start - motion.time(knot));
    leg.response = respond(i);
    if (motion.leg(i).end == LegEnd::cut && !motion.start_moves(i)) continue;
    leg.acceleration =
        motion.acceleration(i, Scalar(leg.start + leg.duration), leg.ramp.after(leg.duration));
  }
}

/// The flights of a motion, linearised, with these terms, one for each leg.
std::vector<LinearLeg<double>> linear_legs(const ProfileMotion& motion,
                                           const std::vector<EventTerm>& terms);

}  // namespace ricochet::carrier_track::inline gradients
