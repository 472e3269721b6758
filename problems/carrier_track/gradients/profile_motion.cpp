#include "problems/carrier_track/gradients/profile_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "problems/carrier_track/motion/forces.h"
#include "problems/carrier_track/scene/contact_law.h"

namespace ricochet::carrier_track::inline gradients {

ProfileMotion::ProfileMotion(const Scene& scene, std::vector<MotionLeg> legs)
    : plate_(plate_forces(scene)),
      disturbance_(disturbance_of(scene)),
      friction_(scene.friction * scene.normal_force / scene.mass),
      restitution_{lower_restitution(scene), upper_restitution(scene)},
      phase_(scene.phase),
      legs_(std::move(legs)) {
  for (const SpeedKnot<double>& knot : scene.profile) {
    times_.push_back(knot.time);
    speeds_.push_back(knot.omega);
  }
  ramps_ = ramps<double>(speeds_);
  // As ProfileForces passes the knots, to the last bit.
  double now = 0;
  std::size_t next = 0;
  for (const MotionLeg& leg : legs_) {
    before_.push_back(std::clamp<std::size_t>(next, 1, knots() - 1) - 1);
    double time = leg.duration;
    for (; next < knots() && time >= times_[next] - now; ++next) {
      const double left = times_[next] - now;
      now += left;
      time -= left;
    }
    now += time;
  }
}

PlateRamp<double> ProfileMotion::release(std::size_t i) const {
  using Dual = ceres::Jet<double, 4>;
  const auto& [angle, speed, slope] = ramp(i);
  const Dual excess = acceleration(i, Dual(legs_[i].start, 3),
                                   PlateRamp<Dual>{Dual(angle, 0), Dual(speed, 1), Dual(slope, 2)});
  const RampForces<double> forces{plate_, disturbance_, angle, speed, slope};
  if (std::abs(excess.a) > 1e-9 * bounds_of(forces).size) return {};
  const double rate = excess.v[0] * speed + excess.v[1] * slope + excess.v[3];
  return {-excess.v[0] / rate, -excess.v[1] / rate, -excess.v[2] / rate};
}

std::vector<LinearLeg<double>> linear_legs(const ProfileMotion& motion,
                                           const std::vector<EventTerm>& terms) {
  std::vector<LinearLeg<double>> legs;
  for (std::size_t i = 0; i < motion.size(); ++i) {
    const MotionLeg& leg = motion.leg(i);
    // At a cut the body flies on as it came.
    const double velocity =
        leg.end == LegEnd::cut ? motion.leg(i + 1).velocity : leg.direction * leg.speed;
    legs.push_back({leg.start, leg.duration, velocity, terms[i].slope[0], terms[i].slope[1],
                    motion.released(i) ? motion.release(i) : PlateRamp<double>()});
  }
  complete(motion, motion.ramps(), legs,
           [&](std::size_t i) { return motion.response(i, legs[i].start, legs[i].ramp); });
  return legs;
}

}  // namespace ricochet::carrier_track::inline gradients
