#include "problems/carrier_track/motion/planar_model.h"

#include "problems/carrier_track/scene/scene_values.h"

namespace ricochet::carrier_track::inline models {

namespace {

template <class Forces>
PlanarFriction<Forces> friction_of(const Scene& scene) {
  return {scene.friction, scene.friction * scene.normal_force / scene.mass};
}

/// The members that x and y have in common.
template <class Direction>
Clearance<double> clearance_of(const Direction& direction) {
  return {direction.wall_lower,        direction.wall_upper,     direction.restitution_lower,
          direction.restitution_upper, direction.start_position, direction.start_velocity};
}

}  // namespace

template <class Forces>
PlanarModel<Forces>::PlanarModel(const Scene& scene)
    : duration_(duration_of(scene)),
      x_(Forces(scene), clearance_of(scene), friction_of<Forces>(scene), duration_,
         resting_speed_of(scene)),
      y_(Forces::across(scene), clearance_of(scene.across.value()), friction_of<Forces>(scene),
         duration_, resting_speed_of(scene)) {}

template class PlanarModel<AppliedForces<double>>;
template class PlanarModel<ProfileForces<double>>;

template <class Forces>
double PlanarFriction<Forces>::bound() const {
  if (!load) return steady;
  return steady + coefficient * std::max(0.0, load->direction * load->forces.sum());
}

template <class Forces>
double PlanarFriction<Forces>::size(double of_forces) const {
  return load ? of_forces + coefficient * load->forces.size() : of_forces;
}

template <class Forces>
double PlanarFriction<Forces>::reach(double of_forces) const {
  return load ? std::min(of_forces, load->forces.reach()) : of_forces;
}

template <class Forces>
auto PlanarFriction<Forces>::flight(const Forces& forces, double position, double velocity,
                                    int direction) const -> Path {
  Path path = forces.flight(position, velocity, -direction * steady);
  if (load) {
    path.add(-direction * coefficient * load->direction, load->forces.flight(0, 0, 0));
  }
  return path;
}

/// A varying press moves the two edges of the friction band differently.
template <class Forces>
Event PlanarFriction<Forces>::release(const Path& held, bool may_rise, bool may_fall,
                                      double horizon, std::int64_t& evaluations) const {
  if (!load) return next_release(held, steady, may_rise, may_fall, horizon, evaluations);
  const Path press = load->forces.flight(0, 0, 0);
  const double factor = coefficient * load->direction;
  Path upper = held;
  upper.add(-factor, press);
  const Event up = next_release(upper, steady, may_rise, false, horizon, evaluations);
  Path lower = held;
  lower.add(factor, press);
  const Event down = next_release(lower, steady, false, may_fall, up.time, evaluations);
  return down.kind == EventKind::release ? down : up;
}

/// Finds the path from the current state, and the event that ends it.
template <class Forces>
void PlanarAxis<Forces>::set_out() {
  std::optional<double> hops;
  if (struck_) hops = this->rest_after_hops();
  struck_ = false;
  if (direction_ == 0 && !hops) direction_ = this->direction_of_release();
  if (hops) {
    event_ = {EventKind::turn, *hops, 0};
  } else if (direction_ == 0) {
    const auto rest = this->next_rest();
    event_ = {rest.direction == 0 ? EventKind::horizon : EventKind::release, rest.time,
              rest.direction};
  } else {
    landing_ = flight_ = this->flight();
    const auto end = this->advance_to_event(*landing_);
    event_ = {end.kind, end.time, direction_};
  }
  const bool last = event_.kind == EventKind::horizon && event_.time >= duration_ - time_;
  ends_ = last ? never : time_ + event_.time;
  press_ = 0;
  press_changes_ = never;
  // Without a coefficient of friction the press has no effect.
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

/// Finds when the press of a body that rests on a wall begins or ends: when the force leaves a band
/// of zero width.
template <class Forces>
void PlanarAxis<Forces>::watch_press(double now, const Forces& forces) {
  const int turned = press_ != 0 ? -press_ : inward();
  const Event event = next_release(forces.flight(0, 0, 0), 0.0, turned > 0, turned < 0,
                                   std::min(duration_ - now, forces.reach()), this->evaluations_);
  press_changes_ = event.kind == EventKind::release ? now + event.time : never;
}

template <class Forces>
void PlanarAxis<Forces>::change_press(double now) {
  press_ = press_ != 0 ? 0 : inward();
  watch_press(now, forces_at(now));
}

template struct PlanarFriction<AppliedForces<double>>;
template struct PlanarFriction<ProfileForces<double>>;
template class PlanarAxis<AppliedForces<double>>;
template class PlanarAxis<ProfileForces<double>>;

}  // namespace ricochet::carrier_track::inline models
