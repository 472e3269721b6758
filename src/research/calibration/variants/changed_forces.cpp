#include "src/research/calibration/variants/changed_forces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/carrier_track/events/stick_release.h"

namespace ricochet::studies::variants {

using namespace carrier_track;

namespace {

AppliedForces<double> forces_across(Scene scene, const Press& press) {
  if (scene.centrifugal == Centrifugal::projected) {
    scene.slider_mass_radius += scene.centrifugal_mass_radius;
  }
  scene.across.emplace().pull = press.pull;
  return AppliedForces<double>::across(scene);
}

}  // namespace

ChangedForces::ChangedForces(const Scene& scene, const MotionChange& change)
    : change_(change), mass_(scene.mass), plate_(scene) {
  if (change.press) across_ = forces_across(scene, *change.press);
  begin_piece();
}

ChangedForces::Path ChangedForces::press() const {
  Path path = across_->flight(0, 0, 0);
  path.steady *= across_sign_;
  for (auto& harmonic : path.harmonic) {
    harmonic.cosine *= across_sign_;
    harmonic.sine *= across_sign_;
  }
  return path;
}

void ChangedForces::tick(double time) {
  if (across_) across_->pass(time);
  if (time < reach()) {
    time_ += time;
    return;
  }
  time_ = until_;
  begin_piece();
}

void ChangedForces::begin_piece() {
  until_ = std::numeric_limits<double>::infinity();
  if (const auto& force = change_.further_force) {
    const auto end = [&] { return static_cast<double>(interval_ + 1) * force->interval; };
    if (time_ >= end()) ++interval_;
    until_ = end();
    held_ = force->height(interval_) / mass_;
  }
  if (across_) {
    until_ = std::min(until_, time_ + until_across_turns());
    const double middle = std::isfinite(until_) ? 0.5 * (until_ - time_) : 0.0;
    across_sign_ = across_->flight(0, 0, 0).at(middle).acceleration < 0 ? -1 : 1;
  }
}

/// [s] until the force along y is next 0, ignoring a present zero within rounding.
double ChangedForces::until_across_turns() const {
  constexpr double turn = 2 * std::numbers::pi;
  constexpr double now = 1e-9;  // [rad]
  const Path path = across_->flight(0, 0, 0);
  const auto& harmonic = path.harmonic[0];
  const double amplitude = std::hypot(harmonic.cosine, harmonic.sine);
  if (!(amplitude > std::abs(path.steady)) || !(harmonic.frequency > 0)) {
    return std::numeric_limits<double>::infinity();
  }
  const double angle = std::atan2(harmonic.sine, harmonic.cosine);
  const double zero = std::acos(-path.steady / amplitude);
  double next = turn;
  for (const double at : {zero, -zero}) {
    double ahead = std::remainder(at - angle, turn);
    if (ahead < now) ahead += turn;
    next = std::min(next, ahead);
  }
  return next / harmonic.frequency;
}

double ChangedFriction::bound() const {
  return varies() ? steady + coefficient * std::max(0.0, forces->press().acceleration()) : steady;
}

double ChangedFriction::size(double of_forces) const {
  return varies() ? of_forces + coefficient * forces->press().size() : of_forces;
}

ChangedFriction::Path ChangedFriction::flight(const ChangedForces& applied, double position,
                                              double velocity, int direction) const {
  Path path = applied.flight(position, velocity, direction > 0 ? -steady : steady);
  if (varies()) path.add(-direction * coefficient, forces->press());
  return path;
}

/// A normal force that varies moves both edges of the friction band independently.
Event ChangedFriction::release(const Path& held, bool may_rise, bool may_fall, double horizon,
                               std::int64_t& evaluations) const {
  if (!varies()) return next_release(held, steady, may_rise, may_fall, horizon, evaluations);
  Path upper = held;
  upper.add(-coefficient, forces->press());
  const Event up = next_release(upper, steady, may_rise, false, horizon, evaluations);
  Path lower = held;
  lower.add(coefficient, forces->press());
  const Event down = next_release(lower, steady, false, may_fall, up.time, evaluations);
  return down.kind == EventKind::release ? down : up;
}

}  // namespace ricochet::studies::variants
