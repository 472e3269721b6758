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

/// What the law makes of a wall's restitution.
double damping_of(ContactLaw law, double restitution) {
  return law == ContactLaw::kelvin_voigt ? damping_ratio(restitution, Release::zero_force)
                                         : dissipation(law, restitution);
}

}  // namespace

CompliantModel::CompliantModel(const Scene& scene, double tolerance)
    : scene_(scene),
      tolerance_(tolerance),
      duration_(duration_of(scene)),
      friction_(scene.friction * scene.normal_force / scene.mass),
      origin_(scene.start_position),
      velocity_(scene.start_velocity),
      motion_(tolerance) {
  const double centrifugal = scene.centrifugal_mass_radius * scene.omega * scene.omega;
  double turning = -scene.slider_mass_radius * scene.omega * scene.omega;
  (scene.pull_rotates ? turning : steady_) -= scene.pull;
  switch (scene.centrifugal) {
    case Centrifugal::projected:
      turning += centrifugal;
      break;
    case Centrifugal::inward:
      steady_ -= centrifugal;
      break;
    case Centrifugal::outward:
      steady_ += centrifugal;
      break;
  }
  steady_ /= scene.mass;
  const double amplitude = turning / scene.mass;
  harmonic_[0] = {amplitude * std::cos(scene.phase), amplitude * std::sin(scene.phase),
                  scene.omega};
  harmonic_[1] = {scene.disturbance / scene.mass, 0, scene.disturbance_frequency};
  harmonics_ = scene.disturbance == 0 ? 1 : 2;
  damping_ = {damping_of(scene.contact_law, scene.restitution_lower),
              damping_of(scene.contact_law, scene.restitution_upper)};
  if (scene.start_position == scene.wall_lower) wall_ = Wall::lower;
  if (scene.start_position == scene.wall_upper) wall_ = Wall::upper;
  direction_ = sign(velocity_);
  if (direction_ == 0) stop();
  rising_ = direction_ > 0;
}

/// Acceleration by the applied forces, and in `size` the sum of their magnitudes.
double CompliantModel::applied(double& size) const {
  double sum = steady_;
  size = std::abs(steady_);
  for (int i = 0; i < harmonics_; ++i) {
    const double cosine = harmonic_[static_cast<std::size_t>(i)].cosine;
    sum += cosine;
    size += std::abs(cosine);
  }
  return sum;
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
  double size = 0;
  const double push = inward() * applied(size) - friction_;
  if (push <= tolerance_ * (size + friction_)) return;
  double strongest = std::abs(steady_);
  for (const auto& h : harmonic_) strongest += std::hypot(h.cosine, h.sine);
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
  if (rising_ && !summit_) summit_ = Summit{time_, position()};
  double size = 0;
  double push = applied(size);
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
  double size = 0;
  applied(size);
  for (const auto& h : harmonic_) size += std::abs(h.sine);
  Flight<double> held = flight(steady_);
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
  Flight<double> push{0, 0, into * steady_ - direction * friction_, harmonic_, harmonics_};
  for (auto& h : push.harmonic) {
    h.cosine *= into;
    h.sine *= into;
  }
  const double left = duration_ - time_;
  const ContactEvent event = motion_.step(push, direction, left, evaluations_);
  offset_ = into * motion_.depth();
  velocity_ = into * motion_.speed();
  pass(motion_.elapsed(), event == ContactEvent::horizon);
  return event;
}

/// Lets `time` pass for the clock and the harmonics' angles; the angles keep unit amplitude.
void CompliantModel::pass(double time, bool to_the_end) {
  time_ = to_the_end ? duration_ : time_ + time;
  for (int i = 0; i < harmonics_; ++i) {
    auto& h = harmonic_[static_cast<std::size_t>(i)];
    const double u = h.frequency * time;
    const auto [c2, c3] = stumpff(u);
    const double cosine = 1 - u * u * c2;
    const double sine = u * (1 - u * u * c3);
    h = {h.cosine * cosine - h.sine * sine, h.sine * cosine + h.cosine * sine, h.frequency};
  }
}

}  // namespace ricochet::carrier_track
