#include "problems/carrier_track/motion/event.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "problems/carrier_track/motion/ramp_flight.h"

namespace ricochet::carrier_track::inline events {

/// Smallest h > 0 with value + slope h - bound h^2 / 2 = 0, for value >= 0; infinite if there is
/// none: no function with this value and slope, whose second derivative is at least -bound, is
/// negative before h.
inline double step_bound(double value, double slope, double bound) {
  const double root = std::sqrt(slope * slope + 2 * bound * value);
  if (slope < 0) return 2 * value / (root - slope);
  return bound > 0 ? (slope + root) / bound : std::numeric_limits<double>::infinity();
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The search for the first event of one path. Most paths are short compared with the period of
/// their forces, or fast compared with the speed change that the forces can cause. Bounds from the
/// start alone then prove which event comes first and that it is the only one in reach, and a few
/// steps find it.
template <class Path>
class Search {
 public:
  Search(Path& path, int direction, double ahead, double horizon, std::int64_t& evaluations)
      : there_(path),
        start_(path.position),
        direction_(direction),
        ahead_(ahead),
        horizon_(horizon),
        evaluations_(evaluations),
        speed_(std::max(direction * path.velocity, 0.0)),
        acceleration_(direction * path.acceleration()),
        jerk_(direction * path.jerk()),
        snap_(direction * path.snap()),
        jerk_bound_(path.jerk_bound()),
        noise_(1e-9 * path.size()) {}

  Event first() {
    if (short_turn()) return {EventKind::turn, time_, direction_};
    if (short_arrival() || fast_arrival()) return {EventKind::wall, time_, direction_};
    return advance_conservatively();
  }

 private:
  /// A turning point that certainly comes first: speed <= v + a t + J t^2 / 2 crosses zero while
  /// the acceleration is still negative, and before the wall can be reached.
  bool short_turn() {
    const double certain = acceleration_ * acceleration_ - 2 * jerk_bound_ * speed_;
    if (!(acceleration_ < -noise_ && speed_ > 0 && certain > 0)) return false;
    const double inverse = -1 / acceleration_;
    const double plain = speed_ * inverse;  // the time of the turning point without jerk
    double latest = 2 * plain;
    if (!(latest < horizon_ && speed_ * plain < ahead_)) {
      latest = 2 * speed_ / (std::sqrt(certain) - acceleration_);
      if (!(latest < horizon_ && 0.5 * speed_ * latest < ahead_)) return false;
    }
    // Zero of v + a t + j t^2 / 2 + s t^3 / 6, by reversion of the series.
    const double b = 0.5 * jerk_ * plain * inverse;
    const double c = snap_ * plain * plain * inverse / 6;
    const Path start = there_;
    const double guess = plain * (1 + b + c + b * (2 * b + 5 * (b * b + c)));
    advance(guess > 0 && guess < latest ? guess : plain);
    for (int i = 0; i < 6; ++i) {
      const double slope = direction_ * there_.acceleration();
      const double step = std::min(-direction_ * there_.velocity / slope, latest - time_);
      advance(step);
      // Newton's next error is below J step^2 / (2 |a|).
      const bool converged = jerk_bound_ * step * step <= -2 * epsilon * slope * time_;
      if (converged && time_ > 0) return true;
    }
    there_ = start;
    time_ = 0;
    return false;
  }

  /// An arrival that certainly comes first: the speed is at least v + a t - J t^2 / 2, and this
  /// bound stays positive until its integral exceeds the distance to the wall.
  bool short_arrival() {
    const double square = speed_ * speed_ + 2 * acceleration_ * ahead_;
    if (!(square > 0 && speed_ >= 0)) return false;
    const double time = 2 * ahead_ / (speed_ + std::sqrt(square));
    const double latest = 1.25 * time;
    const double slow = speed_ + latest * (acceleration_ - latest * jerk_bound_ / 2);
    const double near = latest * (speed_ + latest * (acceleration_ / 2 - latest * jerk_bound_ / 6));
    const bool accelerates = speed_ > 0 || acceleration_ > noise_;
    if (!(slow > 0 && near > ahead_ && latest < horizon_ && accelerates)) return false;
    // One Newton step on the quartic with the jerk and snap at the start.
    const double miss =
        time * (speed_ + time * (acceleration_ / 2 + time * (jerk_ / 6 + time * snap_ / 24))) -
        ahead_;
    const double guess =
        time - miss / (speed_ + time * (acceleration_ + time * (jerk_ / 2 + time * snap_ / 6)));
    advance(guess > 0 && guess < latest ? guess : time);
    arrive(0, latest, jerk_bound_);
    return true;
  }

  /// The same if the forces pass through whole periods on the way but cannot stop the body.
  bool fast_arrival() {
    if (!(speed_ > 0)) return false;
    const double latest = 2 * ahead_ / speed_;
    if (!(latest < horizon_)) return false;
    const auto [least, mean] = there_.speeds(direction_, latest);
    if (!(least > 0 && least * latest > ahead_)) return false;
    const double guess = ahead_ / mean;
    advance(guess > 0 && guess < latest ? guess : latest / 2);
    arrive(0, latest, jerk_bound_);
    return true;
  }

  /// Conservative advancement: each step is so short that, by the bound on the jerk, the speed
  /// stays positive.
  Event advance_conservatively() {
    const ForceBounds bounds = there_.bounds(horizon_);
    double least_step = bounds.shortest_step;
    double step = step_bound(speed_, acceleration_, bounds.jerk);
    if (speed_ <= 0) {  // starts from rest with the force just above friction
      if (jerk_ > 0) step = std::max(step, 3 * jerk_ / bounds.snap);
      step = std::max(step, bounds.shortest_step);
    }
    for (;;) {
      const Path here = there_;
      const double before = time_;
      const bool last = time_ + step >= horizon_;
      step = last ? horizon_ - time_ : step;
      advance(step);
      if (distance() > 2 * ahead_) {
        // Far beyond the wall, rounding would be large compared with the distance to it.
        there_ = here;
        time_ = before;
        step /= 2;
        continue;
      }
      if (distance() >= ahead_) {
        arrive(before, time_, bounds.jerk);
        return {EventKind::wall, time_, direction_};
      }
      if (last) return {EventKind::horizon, horizon_, direction_};
      const double noise = 4 * epsilon * (speed_ + bounds.acceleration * time_);
      double speed = direction_ * there_.velocity;
      const double acceleration = direction_ * there_.acceleration();
      if (speed <= noise) {
        if (acceleration <= 0) return {EventKind::turn, time_, direction_};
        speed = std::max(speed, 0.0);
      }
      step = std::max(step_bound(speed, acceleration, bounds.jerk), epsilon * time_);
      // While the speed is zero within rounding, steps double.
      least_step = speed <= noise ? 2 * least_step : bounds.shortest_step;
      if (speed <= noise) step = std::max(step, least_step);
    }
  }

  /// Advances the path to its arrival at the wall, which lies within the times [lower, upper],
  /// where the distance is monotone; `jerk` bounds the third derivative.
  void arrive(double lower, double upper, double jerk) {
    for (int i = 0; i < 100; ++i) {
      const double gap = ahead_ - distance();
      (gap > 0 ? lower : upper) = time_;
      const double speed = direction_ * there_.velocity;
      const double acceleration = direction_ * there_.acceleration();
      // The step of the local parabola, as a series if the speed changes little.
      const double straight = gap / speed;
      const double bend = acceleration * straight / speed;
      double step = straight * (1 - bend / 2 + bend * bend / 2);
      double error = jerk * std::abs(step * step * step) / (6 * speed) +
                     std::abs(straight * bend * bend * bend);
      if (!(speed > 0 && std::abs(bend) < 1e-2)) {
        const double end = std::sqrt(speed * speed + 2 * acceleration * gap);  // at the wall
        step = 2 * gap / (speed + end);
        error = jerk * std::abs(step * step * step) / (6 * end);
      }
      if (std::abs(step) <= 2 * epsilon * time_ || upper - lower <= 2 * epsilon * upper) break;
      const double next = time_ + step;
      if (!(next > lower && next < upper)) {  // also if the step is NaN
        step = lower + 0.5 * (upper - lower) - time_;
        error = infinity;
      }
      advance(step);
      if (error <= epsilon * time_) break;
    }
  }

  void advance(double time) {
    ++evaluations_;
    there_.advance(time);
    time_ += time;
  }

  double distance() const { return direction_ * (there_.position - start_); }

  Path& there_;
  double time_ = 0;  // of there_
  double start_;     // position
  int direction_;
  double ahead_;
  double horizon_;
  std::int64_t& evaluations_;
  // At the start, in the direction of travel.
  double speed_;
  double acceleration_;
  double jerk_;
  double snap_;
  double jerk_bound_;
  double noise_;  // an acceleration below this may be rounding
};

}  // namespace

template <class Path>
Event next_event(Path& path, int direction, double ahead, double horizon,
                 std::int64_t& evaluations) {
  if (ahead <= 0) return {EventKind::wall, 0, direction};
  return Search<Path>(path, direction, ahead, horizon, evaluations).first();
}

template Event next_event(Flight<double>&, int, double, double, std::int64_t&);
template Event next_event(RampFlight<double>&, int, double, double, std::int64_t&);

template <class Path>
Event next_release(const Path& applied, double friction, bool may_rise, bool may_fall,
                   double horizon, std::int64_t& evaluations) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const ForceBounds bounds = applied.bounds(horizon);
  const double noise = 4 * epsilon * (bounds.acceleration + friction);
  const double slope_noise = 4 * epsilon * bounds.jerk;
  if (bounds.jerk <= 0) return {EventKind::horizon, horizon, 0};
  double time = 0;
  double least_step = bounds.shortest_step;
  for (;;) {
    const auto [push, slope] = applied.applied_at(time);
    ++evaluations;
    double step = infinity;
    bool at_the_edge = false;
    for (const int direction : {+1, -1}) {
      if (direction > 0 ? !may_rise : !may_fall) continue;
      const double reserve = friction - direction * push;
      const double reserve_slope = -direction * slope;
      // The force is already outside the band by more than the rounding of cancelling forces: it
      // jumps at a knot of a speed profile.
      const bool jumped = reserve < -1e-9 * (bounds.acceleration + friction);
      if (jumped || (reserve <= noise && reserve_slope < -slope_noise)) {
        return {EventKind::release, time, direction};
      }
      step = std::min(step, step_bound(std::max(reserve, 0.0), reserve_slope, bounds.snap));
      at_the_edge = at_the_edge || reserve <= noise;
    }
    // While the force equals the band's edge within rounding, steps double.
    least_step = at_the_edge ? 2 * least_step : bounds.shortest_step;
    if (at_the_edge) step = std::max(step, least_step);
    if (time >= horizon || step == infinity) return {EventKind::horizon, horizon, 0};
    time = std::min(time + std::max(step, epsilon * time), horizon);
  }
}

template Event next_release(const Flight<double>&, double, bool, bool, double, std::int64_t&);
template Event next_release(const RampFlight<double>&, double, bool, bool, double, std::int64_t&);

}  // namespace ricochet::carrier_track::inline events
