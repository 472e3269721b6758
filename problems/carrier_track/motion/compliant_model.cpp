#include "problems/carrier_track/motion/compliant_model.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "problems/carrier_track/scene/contact_law.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track::inline models {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

}  // namespace

template <class Forces>
CompliantModel<Forces>::CompliantModel(const Scene& scene, double tolerance)
    : scene_(scene),
      tolerance_(tolerance),
      duration_(duration_of(scene)),
      friction_(scene.friction * scene.normal_force / scene.mass),
      forces_(scene),
      origin_(scene.start_position),
      velocity_(scene.start_velocity),
      motion_(tolerance) {
  damping_ = {damping_factor(scene.contact_law, lower_restitution(scene)),
              damping_factor(scene.contact_law, upper_restitution(scene))};
  if (scene.start_position == scene.wall_lower) wall_ = Wall::lower;
  if (scene.start_position == scene.wall_upper) wall_ = Wall::upper;
  direction_ = direction_of(velocity_);
  if (direction_ == 0) stop();
}

/// Acceleration up to which friction holds a body without velocity, for forces of magnitude `size`.
template <class Forces>
double CompliantModel<Forces>::hold(double size) const {
  return friction_ + 4 * epsilon * size;
}

template <class Forces>
ContactForce CompliantModel<Forces>::contact_force(double approach_speed) const {
  const double factor = damping_[wall_ == Wall::upper ? 1 : 0];
  const double stiffness = scene_.stiffness / scene_.mass;
  if (scene_.contact_law == ContactLaw::kelvin_voigt) {
    return {stiffness, 1, 2 * factor * std::sqrt(stiffness), true};
  }
  return {stiffness, scene_.contact_exponent,
          factor / scene_.contact_speed.value_or(approach_speed), false};
}

/// Puts the body exactly on the wall that it has reached, and returns its speed.
template <class Forces>
double CompliantModel<Forces>::reach_wall() {
  count_impact(impacts_);
  wall_ = direction_ > 0 ? Wall::upper : Wall::lower;
  origin_ = wall_ == Wall::upper ? scene_.wall_upper : scene_.wall_lower;
  offset_ = 0;
  return std::max(direction_ * velocity_, 0.0);
}

/// Starts a contact at the surface of the wall touched.
template <class Forces>
void CompliantModel<Forces>::enter(double speed) {
  if (speed <= resting_speed_of(scene_)) {
    velocity_ = 0;
    stop();
    return;
  }
  const ContactForce force = contact_force(speed);
  const double factor = force.viscous ? 0.0 : force.damping * speed;
  in_contact_ = true;
  motion_.begin(force, 0, speed,
                peak_penetration(force.stiffness, force.exponent, 1, speed, factor), speed);
}

/// Moves a body at rest on the surface of a wall to the depth at which the wall balances the press,
/// unless the press is only rounding.
template <class Forces>
void CompliantModel<Forces>::settle() {
  const double push = inward() * forces_.sum() - friction_;
  if (push <= tolerance_ * (forces_.size() + friction_)) return;
  const double strongest = forces_.strongest();
  const double deepest = resting_depth(strongest);
  const double speed = std::sqrt(strongest * deepest);
  in_contact_ = true;
  motion_.begin(contact_force(speed), resting_depth(push), 0, deepest, speed);
  offset_ = inward() * motion_.depth();
}

/// Depth [m] at which the wall balances a press [m/s^2].
template <class Forces>
double CompliantModel<Forces>::resting_depth(double press) const {
  return std::pow(press * scene_.mass / scene_.stiffness, 1 / scene_.contact_exponent);
}

/// Sets the direction of a body whose velocity has reached zero.
template <class Forces>
void CompliantModel<Forces>::stop() {
  velocity_ = 0;
  peaks_.stops(time_, position());
  double size = forces_.size();
  double push = forces_.sum();
  if (in_contact_) {
    const double resting = motion_.resting_force();
    push -= inward() * resting;
    size += resting;
  }
  const double limit = hold(size);
  release(push > limit ? +1 : push < -limit ? -1 : 0);
}

/// Returns when and in which direction a body at rest starts to move.
template <class Forces>
Event CompliantModel<Forces>::departure() {
  const double size = forces_.strongest();
  Path held = forces_.flight(offset_, velocity_, 0);
  double limit = friction_;
  if (in_contact_) {
    const double resting = motion_.resting_force();
    held.push(-inward() * resting);
    limit = hold(size + resting);
  } else if (wall_) {
    // The band is widened on the inward side by the amount that settle() needs to find a depth.
    // Otherwise the body would start and stop for ever.
    const double margin = 2 * tolerance_ * (size + friction_);
    held.push(-inward() * 0.5 * margin);
    limit += 0.5 * margin;
  }
  return next_release(held, limit, true, true, horizon(), evaluations_);
}

/// Starts the motion from rest, or keeps the rest for direction 0. A body pressed onto the surface
/// of a wall settles in it.
template <class Forces>
void CompliantModel<Forces>::release(int direction) {
  direction_ = direction;
  if (direction != 0 && wall_ && !in_contact_ && direction == inward()) {
    direction_ = 0;
    settle();
  }
}

template <class Forces>
ContactEvent CompliantModel<Forces>::step() {
  if (++steps_ > contact_step_limit) {
    throw std::runtime_error("the simulation has more than 50000000 steps in contact");
  }
  const int into = inward();
  const int direction = direction_ * into;
  const double drag = direction * friction_;
  const Path path = forces_.flight(0, 0, 0);
  const auto exact = [&](double time) { return into * path.at(time).acceleration - drag; };
  ContactPush push{path.taylor(), std::cref(exact)};  // a copy would allocate at every step
  for (double& c : push.taylor.coefficient) c *= into;
  push.taylor.coefficient[0] -= drag;
  const ContactEvent event = motion_.step(push, direction, horizon(), evaluations_);
  offset_ = into * motion_.depth();
  velocity_ = into * motion_.speed();
  forces_.pass(motion_.elapsed());
  tick(motion_.elapsed());
  return event;
}

/// Time until the end of the window, or until the forces must be updated.
template <class Forces>
double CompliantModel<Forces>::horizon() const {
  return std::min(duration_ - time_, forces_.reach());
}

/// Advances the clock by `time`.
template <class Forces>
void CompliantModel<Forces>::tick(double time) {
  time_ = time >= duration_ - time_ ? duration_ : time_ + time;
}

template class CompliantModel<AppliedForces<double>>;
template class CompliantModel<ProfileForces<double>>;

}  // namespace ricochet::carrier_track::inline models
