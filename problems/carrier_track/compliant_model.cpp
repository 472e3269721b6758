#include "problems/carrier_track/compliant_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "problems/carrier_track/contact_law.h"

namespace ricochet::carrier_track {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

int sign(double x) {
  return (x > 0) - (x < 0);
}

}  // namespace

CompliantModel::CompliantModel(const Scene& scene, double tolerance)
    : scene_(scene),
      tolerance_(tolerance),
      duration_(duration_of(scene)),
      friction_(scene.friction * scene.normal_force / scene.mass),
      forces_(scene),
      origin_(scene.start_position),
      velocity_(scene.start_velocity),
      motion_(tolerance) {
  damping_ = {damping_factor(scene.contact_law, scene.restitution_lower),
              damping_factor(scene.contact_law, scene.restitution_upper)};
  if (scene.start_position == scene.wall_lower) wall_ = Wall::lower;
  if (scene.start_position == scene.wall_upper) wall_ = Wall::upper;
  direction_ = sign(velocity_);
  if (direction_ == 0) stop();
}

/// Acceleration up to which a body without velocity is held where the forces have some `size`.
double CompliantModel::hold(double size) const {
  return friction_ + 4 * epsilon * size;
}

ContactForce CompliantModel::contact_force(double approach_speed) const {
  const double factor = damping_[wall_ == Wall::upper ? 1 : 0];
  const double stiffness = scene_.stiffness / scene_.mass;
  if (scene_.contact_law == ContactLaw::kelvin_voigt) {
    return {stiffness, 1, 2 * factor * std::sqrt(stiffness), true};
  }
  return {stiffness, scene_.contact_exponent,
          factor / scene_.contact_speed.value_or(approach_speed), false};
}

/// Puts the body that has arrived exactly at the wall, and returns its speed.
double CompliantModel::reach_wall() {
  if (++impacts_ > impact_limit) {
    throw std::runtime_error("the simulation has more than 10000000 impacts in its window");
  }
  wall_ = direction_ > 0 ? Wall::upper : Wall::lower;
  origin_ = wall_ == Wall::upper ? scene_.wall_upper : scene_.wall_lower;
  offset_ = 0;
  return std::max(direction_ * velocity_, 0.0);
}

/// Begins a contact at the surface of the wall touched.
void CompliantModel::enter(double speed) {
  if (speed <= resting_speed) {
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

/// Puts a body at rest on the surface of a wall into it, as deep as the press carries, unless
/// nothing presses but rounding.
void CompliantModel::settle() {
  const double push = inward() * forces_.sum() - friction_;
  if (push <= tolerance_ * (forces_.size() + friction_)) return;
  double strongest = std::abs(forces_.steady());
  for (const auto& h : forces_.harmonic()) strongest += std::hypot(h.cosine, h.sine);
  const double deepest = resting_depth(strongest);
  const double speed = std::sqrt(strongest * deepest);
  in_contact_ = true;
  motion_.begin(contact_force(speed), resting_depth(push), 0, deepest, speed);
  offset_ = inward() * motion_.depth();
}

/// Depth [m] that carries a press [m/s^2].
double CompliantModel::resting_depth(double press) const {
  return std::pow(press * scene_.mass / scene_.stiffness, 1 / scene_.contact_exponent);
}

/// The velocity has come down to zero: where the body goes now.
void CompliantModel::stop() {
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
  depart(push > limit ? +1 : push < -limit ? -1 : 0);
}

/// When and where a body at rest sets out.
Event CompliantModel::departure() {
  double size = forces_.size();
  for (const auto& h : forces_.harmonic()) size += std::abs(h.sine);
  Flight<double> held = forces_.flight(offset_, velocity_, 0);
  double limit = friction_;
  if (in_contact_) {
    const double resting = motion_.resting_force();
    held.steady -= inward() * resting;
    limit = hold(size + resting);
  } else if (wall_) {
    // The band is widened on the inward side by what settle() needs to find a depth. Else the body
    // would set out, and stay, for ever.
    const double margin = 2 * tolerance_ * (size + friction_);
    held.steady -= inward() * 0.5 * margin;
    limit += 0.5 * margin;
  }
  return next_departure(held, limit, true, true, duration_ - time_, evaluations_);
}

/// Sets out from rest, or stays for 0; a body pressed onto the surface of a wall settles in it.
void CompliantModel::depart(int direction) {
  direction_ = direction;
  if (direction != 0 && wall_ && !in_contact_ && direction == inward()) {
    direction_ = 0;
    settle();
  }
}

ContactEvent CompliantModel::step() {
  if (++steps_ > contact_step_limit) {
    throw std::runtime_error("the simulation has more than 50000000 steps in contact");
  }
  const int into = inward();
  const int direction = direction_ * into;
  Flight<double> push = forces_.flight(0, 0, 0);
  push.steady = into * push.steady - direction * friction_;
  for (auto& h : push.harmonic) {
    h.cosine *= into;
    h.sine *= into;
  }
  const double left = duration_ - time_;
  const ContactEvent event = motion_.step(push, direction, left, evaluations_);
  offset_ = into * motion_.depth();
  velocity_ = into * motion_.speed();
  forces_.pass(motion_.elapsed());
  tick(motion_.elapsed(), event == ContactEvent::horizon);
  return event;
}

/// Lets `time` pass for the clock.
void CompliantModel::tick(double time, bool to_the_end) {
  time_ = to_the_end ? duration_ : time_ + time;
}

}  // namespace ricochet::carrier_track
