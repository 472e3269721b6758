#include "problems/carrier_track/models/planar_axis.h"

#include "problems/carrier_track/events/zeno_tail.h"

namespace ricochet::carrier_track::inline models {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

}  // namespace

template <class Forces>
PlanarAxis<Forces>::PlanarAxis(const Forces& forces, const Clearance& clearance,
                               const PlanarFriction& friction, double duration)
    : clearance_(clearance),
      friction_(friction),
      duration_(duration),
      forces_(forces),
      origin_(clearance.start_position),
      velocity_(clearance.start_velocity),
      direction_(direction_of(clearance.start_velocity)) {
  if (clearance.start_position == clearance.wall_lower) wall_ = Wall::lower;
  if (clearance.start_position == clearance.wall_upper) wall_ = Wall::upper;
}

/// Puts the body on the wall that it has reached, and turns it round. Returns the approach speed.
template <class Forces>
double PlanarAxis<Forces>::meet_wall() {
  count_impact(impacts_);
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

template <class Forces>
double PlanarAxis<Forces>::restitution() const {
  return at(Wall::upper) ? clearance_.restitution_upper : clearance_.restitution_lower;
}

/// The velocity has come down to zero.
template <class Forces>
void PlanarAxis<Forces>::stop() {
  velocity_ = 0;
  direction_ = 0;
  peaks_.stops(time_, origin_ + offset_);
}

/// The largest friction at the start of the path [m/s^2].
template <class Forces>
double PlanarAxis<Forces>::friction_bound() const {
  if (!load_) return friction_.steady;
  return friction_.steady +
         friction_.coefficient * std::max(0.0, load_->direction * load_->forces.sum());
}

/// Where a body without velocity goes now; as in ImpactModel, rounding alone does not move it.
template <class Forces>
int PlanarAxis<Forces>::direction_of_release() const {
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
template <class Forces>
std::optional<double> PlanarAxis<Forces>::rest_after_hops() {
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
    const bool still = change <= 1e-3 * (press - friction) && remaining <= horizon();
    if (!still && speed > 1e-15) return std::nullopt;
  }
  velocity_ = 0;
  direction_ = 0;
  return std::min(remaining, duration_ - time_);
}

/// When and where a body at rest sets out. A press that varies moves both edges of the friction
/// band, each its own way.
template <class Forces>
Event PlanarAxis<Forces>::departure() {
  const Path held = forces_.flight(offset_, 0, 0);
  const bool may_rise = !at(Wall::upper);
  const bool may_fall = !at(Wall::lower);
  if (!load_) {
    return next_release(held, friction_.steady, may_rise, may_fall, horizon(), evaluations_);
  }
  const Path load = load_->forces.flight(0, 0, 0);
  const double factor = friction_.coefficient * load_->direction;
  Path upper = held;
  upper.add(-factor, load);
  const Event up = next_release(upper, friction_.steady, may_rise, false, horizon(), evaluations_);
  Path lower = held;
  lower.add(factor, load);
  const Event down = next_release(lower, friction_.steady, false, may_fall, up.time, evaluations_);
  return down.kind == EventKind::release ? down : up;
}

/// Time until the end of the window, or until the forces have to be taken anew.
template <class Forces>
double PlanarAxis<Forces>::horizon() const {
  const double reach = std::min(forces_.reach(), load_ ? load_->forces.reach() : never);
  return std::min(duration_ - time_, reach);
}

/// Finds the path from here, and what ends it.
template <class Forces>
void PlanarAxis<Forces>::set_out() {
  std::optional<double> tail;
  if (struck_) tail = rest_after_hops();
  struck_ = false;
  if (direction_ == 0 && !tail) direction_ = direction_of_release();
  if (direction_ == 0) {
    event_ = tail ? Event{EventKind::turn, *tail, 0} : departure();
  } else {
    path_ = forces_.flight(offset_, velocity_, -direction_ * friction_.steady);
    if (load_) {
      const double factor = -direction_ * friction_.coefficient * load_->direction;
      path_->add(factor, load_->forces.flight(0, 0, 0));
    }
    const double wall = (direction_ > 0 ? clearance_.wall_upper : clearance_.wall_lower) - origin_;
    landing_ = path_;
    event_ =
        next_event(*landing_, direction_, direction_ * (wall - offset_), horizon(), evaluations_);
  }
  const bool last = event_.kind == EventKind::horizon && event_.time >= duration_ - time_;
  ends_ = last ? never : time_ + event_.time;
  press_ = 0;
  press_changes_ = never;
  // Without a coefficient of friction the press acts on nothing.
  if (direction_ == 0 && wall_ && friction_.coefficient > 0) {
    if (inward() * forces_.sum() > 0) press_ = inward();
    watch_press(time_, forces_);
  }
}

/// The forces at a time [s] on the path.
template <class Forces>
Forces PlanarAxis<Forces>::forces_at(double now) const {
  Forces forces = forces_;
  if (now > time_) forces.pass(now - time_);
  return forces;
}

/// Finds when the press of a body that rests on a wall begins or ends: where the force leaves a
/// band of no width.
template <class Forces>
void PlanarAxis<Forces>::watch_press(double now, const Forces& forces) {
  const int turned = press_ != 0 ? -press_ : inward();
  const Event event = next_release(forces.flight(0, 0, 0), 0.0, turned > 0, turned < 0,
                                   std::min(duration_ - now, forces.reach()), evaluations_);
  press_changes_ = event.kind == EventKind::release ? now + event.time : never;
}

template <class Forces>
void PlanarAxis<Forces>::change_press(double now) {
  press_ = press_ != 0 ? 0 : inward();
  watch_press(now, forces_at(now));
}

template class PlanarAxis<AppliedForces<double>>;
template class PlanarAxis<ProfileForces<double>>;

}  // namespace ricochet::carrier_track::inline models
