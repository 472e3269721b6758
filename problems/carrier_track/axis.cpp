#include "problems/carrier_track/axis.h"

#include <stdexcept>

#include "problems/carrier_track/zeno_tail.h"

namespace ricochet::carrier_track {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

int sign(double x) {
  return (x > 0) - (x < 0);
}

/// A flight under the acceleration of `other` too, times a factor. Harmonics in the same place have
/// the same frequency.
Flight<double> combined(Flight<double> flight, double factor, const Flight<double>& other) {
  flight.steady += factor * other.steady;
  for (std::size_t i = 0; i < static_cast<std::size_t>(other.harmonics); ++i) {
    flight.harmonic[i].cosine += factor * other.harmonic[i].cosine;
    flight.harmonic[i].sine += factor * other.harmonic[i].sine;
  }
  flight.harmonics = std::max(flight.harmonics, other.harmonics);
  return flight;
}

}  // namespace

Axis::Axis(const AppliedForces<double>& forces, const Clearance& clearance,
           const AxisFriction& friction, double duration)
    : clearance_(clearance),
      friction_(friction),
      duration_(duration),
      forces_(forces),
      origin_(clearance.start_position),
      velocity_(clearance.start_velocity),
      direction_(sign(clearance.start_velocity)) {
  if (clearance.start_position == clearance.wall_lower) wall_ = Wall::lower;
  if (clearance.start_position == clearance.wall_upper) wall_ = Wall::upper;
}

/// Puts the body on the wall that it has reached, and turns it round. Returns the approach speed.
double Axis::meet_wall() {
  if (++impacts_ > impact_limit) {
    throw std::runtime_error("the simulation has more than 10000000 impacts in its window");
  }
  const double approach = direction_ * velocity_;
  wall_ = direction_ > 0 ? Wall::upper : Wall::lower;
  origin_ = at(Wall::upper) ? clearance_.wall_upper : clearance_.wall_lower;
  offset_ = 0;
  peaks_.stops(time_, origin_);
  direction_ = -direction_;
  velocity_ = direction_ * restitution() * approach;
  struck_ = true;
  return approach;
}

double Axis::restitution() const {
  return at(Wall::upper) ? clearance_.restitution_upper : clearance_.restitution_lower;
}

/// The velocity has come down to zero.
void Axis::stop() {
  velocity_ = 0;
  direction_ = 0;
  peaks_.stops(time_, origin_ + offset_);
}

/// The largest friction at the start of the path [m/s^2].
double Axis::friction_bound() const {
  if (!load_) return friction_.steady;
  return friction_.steady +
         friction_.coefficient * std::max(0.0, load_->direction * load_->forces.sum());
}

/// Where a body without velocity goes now; as in ImpactModel, rounding alone does not move it.
int Axis::direction_of_departure() const {
  const double push = forces_.sum();
  const double friction = friction_bound();
  double size = forces_.size();
  if (load_) size += friction_.coefficient * load_->forces.size();
  const double hold = friction + 4 * epsilon * (friction + size);
  if (push > hold && !at(Wall::upper)) return +1;
  if (push < -hold && !at(Wall::lower)) return -1;
  return 0;
}

/// Ends the hops of a body that has struck a wall where they are the tail of a Zeno sequence: the
/// time that they still take, with the body at rest; nothing for one that leaves the wall.
std::optional<double> Axis::rest_after_hops() {
  const double speed = std::abs(velocity_);
  if (speed > resting_speed) return std::nullopt;
  const double press = -direction_ * forces_.sum();
  const double friction = friction_bound();
  if (press < -friction) return std::nullopt;  // the force leads away from the wall
  double remaining = 0;
  if (press > friction && speed > 0) {
    remaining = zeno_tail(speed, restitution(), press, friction);
    // The press must keep still over the sum, unless the hops are lost in rounding anyway.
    const double change = forces_.jerk_bound() * remaining;
    if (change > 1e-3 * (press - friction) && speed > 1e-15) return std::nullopt;
  }
  velocity_ = 0;
  direction_ = 0;
  return std::min(remaining, duration_ - time_);
}

/// When and where a body at rest sets out. A press that varies moves both edges of the friction
/// band, each its own way.
Event Axis::departure() {
  const Flight<double> held = forces_.flight(offset_, 0, 0);
  const bool may_rise = !at(Wall::upper);
  const bool may_fall = !at(Wall::lower);
  const double horizon = duration_ - time_;
  if (!load_) {
    return next_departure(held, friction_.steady, may_rise, may_fall, horizon, evaluations_);
  }
  const Flight<double> load = load_->forces.flight(0, 0, 0);
  const double factor = friction_.coefficient * load_->direction;
  const Event up = next_departure(combined(held, -factor, load), friction_.steady, may_rise, false,
                                  horizon, evaluations_);
  const Event down = next_departure(combined(held, factor, load), friction_.steady, false, may_fall,
                                    up.time, evaluations_);
  return down.kind == EventKind::depart ? down : up;
}

/// Finds the path from here, and what ends it.
void Axis::set_out() {
  std::optional<double> tail;
  if (struck_) tail = rest_after_hops();
  struck_ = false;
  if (direction_ == 0 && !tail) direction_ = direction_of_departure();
  if (direction_ == 0) {
    path_ = {offset_, 0, 0, {}, 0};
    event_ = tail ? Event{EventKind::turn, *tail, 0} : departure();
  } else {
    path_ = forces_.flight(offset_, velocity_, -direction_ * friction_.steady);
    if (load_) {
      const double factor = -direction_ * friction_.coefficient * load_->direction;
      path_ = combined(path_, factor, load_->forces.flight(0, 0, 0));
    }
    const double wall = (direction_ > 0 ? clearance_.wall_upper : clearance_.wall_lower) - origin_;
    event_ = next_event(path_, direction_, direction_ * (wall - offset_), duration_ - time_,
                        evaluations_);
  }
  ends_ = event_.kind == EventKind::horizon ? never : time_ + event_.time;
  press_ = 0;
  press_changes_ = never;
  // Without a coefficient of friction the press acts on nothing.
  if (direction_ == 0 && wall_ && friction_.coefficient > 0) {
    if (inward() * forces_.sum() > 0) press_ = inward();
    watch_press(time_, forces_);
  }
}

/// The forces at a time [s] on the path.
AppliedForces<double> Axis::forces_at(double now) const {
  AppliedForces<double> forces = forces_;
  if (now > time_) forces.pass(now - time_);
  return forces;
}

/// Finds when the press of a body that rests on a wall begins or ends: where the force leaves a
/// band of no width.
void Axis::watch_press(double now, const AppliedForces<double>& forces) {
  const int turned = press_ != 0 ? -press_ : inward();
  const Event event = next_departure(forces.flight(0, 0, 0), 0.0, turned > 0, turned < 0,
                                     duration_ - now, evaluations_);
  press_changes_ = event.kind == EventKind::depart ? now + event.time : never;
}

void Axis::change_press(double now) {
  press_ = press_ != 0 ? 0 : inward();
  watch_press(now, forces_at(now));
}

}  // namespace ricochet::carrier_track
