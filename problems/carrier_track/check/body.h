#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "problems/carrier_track/check/oracle.h"
#include "ricochet/machine.h"

/// The first point at which a function of time falls below zero, isolated by bounds that exclude
/// missed roots. Slow and simple: the basis of the oracle.
namespace ricochet::carrier_track::inline oracle {

/// A function and two derivatives at one time.
struct Jet {
  long double value, slope, curvature;
};

/// Bounds that hold at all times of a search.
struct JetBounds {
  long double third;        ///< bound on the magnitude of the third derivative
  long double slope_noise;  ///< rounding error of the slope
};

/// The result of a search. In [lower, upper] the function crosses zero once downwards (falls), or
/// stays positive while the caller's event occurs (passes); or it is positive up to the horizon
/// (never).
struct Search {
  enum class End { falls, passes, never } end;
  long double lower, upper;
};

/// Searches (0, horizon] for the first fall of `jet` below zero. `jet(t)` is a Jet; it is zero or
/// positive at 0, and if it is zero its slope is not negative. `noise(t)` bounds its rounding
/// error: values within it count as zero, and zero is no fall. `passed(t)` ends the search early at
/// the end of a piece without roots. `guess` > 0 is the length of the first piece; any value will
/// do.
///
/// A piece of middle m and half width h has no roots if the Taylor expansion about m, with the
/// bound on the third derivative as remainder, proves it for the function, or proves that it is
/// monotone, convex or concave and its ends exclude a root. A piece for which nothing is proved is
/// halved.
template <class Function, class Noise, class Passed>
Search first_fall(const Function& jet, const JetBounds& bounds, const Noise& noise,
                  const Passed& passed, long double horizon, long double guess) {
  constexpr long double last_bit = std::numeric_limits<long double>::epsilon();
  long double lower = 0;
  Jet start = jet(lower);
  if (start.value < -noise(lower)) return {Search::End::falls, lower, lower};
  long double width = std::min(guess, horizon);
  while (lower < horizon) {
    const long double upper = std::min(lower + width, horizon);
    const long double h = (upper - lower) / 2;
    const Jet middle = jet(lower + h);
    const Jet stop = jet(upper);
    const long double rounding = noise(upper);
    const long double slope_reach = std::abs(middle.curvature) * h + bounds.third * h * h / 2;
    const long double reach = std::abs(middle.slope) * h + std::abs(middle.curvature) * h * h / 2 +
                              bounds.third * h * h * h / 6;
    const bool positive = middle.value > reach + rounding;
    const bool rises = middle.slope > slope_reach + bounds.slope_noise;
    const bool drops = middle.slope < -slope_reach - bounds.slope_noise;
    const bool convex = middle.curvature > bounds.third * h;
    const bool concave = middle.curvature < -bounds.third * h;
    const bool zero = std::abs(middle.value) + reach <= 2 * rounding;
    const bool smallest = h <= last_bit * upper;
    if ((drops || smallest) && stop.value < -rounding) {
      return {Search::End::falls, lower, upper};
    }
    const bool free = positive || rises || zero || smallest || drops ||
                      (convex && start.slope >= -bounds.slope_noise) ||
                      (concave && stop.value > rounding);
    if (!free) {
      width = h;
      continue;
    }
    if (passed(upper)) return {Search::End::passes, lower, upper};
    lower = upper;
    start = stop;
    width = 4 * std::max(h, last_bit * upper);
  }
  return {Search::End::never, horizon, horizon};
}

/// The root in [lower, upper] of a function with one sign change there, to the last bits; `lower`
/// if the sign does not change. `jet(t)` is a Jet. Newton's method within a bracket: a step that
/// leaves it, or that is more than half the previous one, is replaced by a bisection.
template <class Function>
long double root_between(const Function& jet, long double lower, long double upper) {
  constexpr long double last_bit = std::numeric_limits<long double>::epsilon();
  const long double low = jet(lower).value;
  if (low == 0) return lower;
  Jet now = jet(upper);
  if ((low > 0) == (now.value > 0) && now.value != 0) return lower;
  long double time = upper;
  long double step = upper - lower;
  while (now.value != 0 && upper - lower > last_bit * upper) {
    const long double before = step;
    step = std::abs(now.value / now.slope);
    long double next = time - now.value / now.slope;
    if (!(next > lower && next < upper && step < before / 2)) {
      if (step <= last_bit * time) break;
      step = (upper - lower) / 2;
      next = lower + step;
      if (next <= lower || next >= upper) break;
    }
    time = next;
    if (step <= last_bit * time) break;
    now = jet(time);
    ((now.value > 0) == (low > 0) ? lower : upper) = time;
  }
  return time;
}

}  // namespace ricochet::carrier_track::inline oracle

/// The motion of a body under a push, in 80-bit numbers: the method of oracle_run().
namespace ricochet::carrier_track::inline oracle::of_body {

using Real = long double;

inline constexpr Real last_bit = std::numeric_limits<Real>::epsilon();
inline constexpr int flight_cap = 20 * static_cast<int>(oracle_impact_cap);

inline Real window_of(const Scene& scene) {
  if (const auto* turns = std::get_if<Revolutions>(&scene.window)) {
    return 2 * std::numbers::pi_v<Real> * turns->count / scene.omega;
  }
  return std::get<Seconds>(scene.window).count;
}

/// The turning point of a rising body: time [s] and height above the lower wall [m].
struct Top {
  Real time, height;
};

/// One step of a body, in the direction in which it moves.
struct Leg {
  enum class End { wall, turn, horizon } end;
  Real time, distance, speed;
};

/// A `Force` is like Push: the applied forces divided by the mass; Force::From is like PushFrom.
template <class Force>
class Body {
  using From = typename Force::From;

 public:
  /// All of the scene but its applied forces.
  Body(const Scene& scene, const Force& push)
      : scene_(scene),
        push_(push),
        friction_(static_cast<Real>(scene.friction) * scene.normal_force / scene.mass),
        window_(window_of(scene)),
        gap_(static_cast<Real>(scene.wall_upper) - scene.wall_lower),
        below_(static_cast<Real>(scene.start_position) - scene.wall_lower),
        above_(static_cast<Real>(scene.wall_upper) - scene.start_position),
        velocity_(scene.start_velocity) {
    const Real operations = 16;
    acceleration_noise_ = last_bit * operations * friction_ + push_.noise(0, window_);
    jerk_noise_ = push_.noise(1, window_);
    for (std::size_t i = 0; i < bound_.size(); ++i) {
      bound_[i] = push_.bound(static_cast<int>(i), window_);
    }
  }

  OracleRun run() {
    while (time_ < window_) {
      if (flights_ == flight_cap || run_.impacts.size() >= oracle_impact_cap) {
        run_.finished = false;
        break;
      }
      horizon_ = std::min(window_, push_.known_until(time_));
      int direction = (velocity_ > 0) - (velocity_ < 0);
      if (direction == 0) direction = rest();
      if (direction != 0) fly(direction);
    }
    return std::move(run_);
  }

 private:
  /// Lets the body rest until the force leaves the friction band towards a free side. Returns the
  /// direction, or 0 if the horizon comes first.
  int rest() {
    const From push(push_, time_);
    Real first = horizon_ - time_;
    int direction = 0;
    for (const int side : {+1, -1}) {
      if ((side > 0 ? above_ : below_) <= 0) continue;
      const auto reserve = [&](Real t) {
        const Pushed p = push.after(t);
        return Jet{friction_ - side * p.acceleration, -side * p.jerk, -side * p.snap};
      };
      const auto noise = [&](Real) { return acceleration_noise_; };
      const auto never = [](Real) { return false; };
      const Search search = first_fall(reserve, {bound_[3], jerk_noise_}, noise, never, first,
                                       std::min(push_.piece(), first));
      if (search.end != Search::End::falls) continue;
      first = root_between(reserve, search.lower, search.upper);
      direction = side;
      if (first == 0) break;
    }
    time_ = direction == 0 ? horizon_ : time_ + first;
    return direction;
  }

  void fly(int direction) {
    set_out(direction);
    const Leg leg = next_leg(direction);
    time_ = leg.end == Leg::End::horizon ? horizon_ : time_ + leg.time;
    if (leg.end != Leg::End::horizon) ++flights_;
    below_ += direction * leg.distance;
    above_ -= direction * leg.distance;
    velocity_ = direction * leg.speed;
    if (leg.end == Leg::End::wall) strike(direction, leg.speed);
    if (leg.end == Leg::End::turn) {
      velocity_ = 0;
      if (direction > 0) run_.summits.push_back({static_cast<double>(time_), below_});
    }
    if (direction > 0 && leg.end != Leg::End::horizon) top_ = {time_, below_};
  }

  /// A height that the body has reached is a maximum once it moves down from there.
  void set_out(int direction) {
    if (top_ && direction < 0) {
      const Real position = scene_.wall_lower + top_->height;
      run_.maxima.push_back({static_cast<double>(top_->time), static_cast<double>(position)});
      if (scene_.rule == CountRule::peaks) run_.count += counted(position);
    }
    top_.reset();
  }

  /// How often a maximum counts: twice if it is both high and low.
  int counted(Real position) const {
    return static_cast<int>(position > scene_.peak_high) +
           static_cast<int>(position < scene_.peak_low);
  }

  Leg next_leg(int direction) const {
    const Real ahead = direction > 0 ? above_ : below_;
    const Real speed = std::abs(velocity_);
    if (ahead <= 0) return {Leg::End::wall, 0, 0, speed};
    const From push(push_, time_);
    const auto after = [&](Real t) {
      const Pushed p = push.after(t);
      return Pushed{t * (speed - friction_ * t / 2) + direction * p.distance,
                    speed - friction_ * t + direction * p.speed,
                    direction * p.acceleration - friction_, direction * p.jerk, direction * p.snap};
    };
    const auto speed_at = [&](Real t) {
      const Pushed p = after(t);
      return Jet{p.speed, p.acceleration, p.jerk};
    };
    const auto beyond = [&](Real t) {
      const Pushed p = after(t);
      return Jet{p.distance - ahead, p.speed, p.acceleration};
    };
    const auto noise = [&](Real t) { return 16 * last_bit * speed + acceleration_noise_ * t; };
    const auto passed = [&](Real t) { return beyond(t).value >= 0; };
    const Real left = horizon_ - time_;
    // While the speed is positive the distance only grows: its first fall bounds the search.
    const Search search = first_fall(speed_at, {bound_[2], acceleration_noise_}, noise, passed,
                                     left, first_piece(speed, ahead, left));
    const auto leg = [&](Leg::End end, Real t) {
      const Pushed p = after(t);
      return Leg{end, t, p.distance, std::max(p.speed, 0.0L)};
    };
    if (search.end == Search::End::never) return leg(Leg::End::horizon, left);
    Real latest = search.upper;
    if (search.end == Search::End::falls) {
      latest = root_between(speed_at, search.lower, search.upper);
      if (beyond(latest).value < 0) return leg(Leg::End::turn, latest);
    }
    return leg(Leg::End::wall, root_between(beyond, search.lower, latest));
  }

  /// Estimated length of the flight; it affects only the cost.
  Real first_piece(Real speed, Real ahead, Real left) const {
    Real guess = std::min(push_.piece(), left);
    if (speed <= 0) return guess;
    const Real acceleration = friction_ + push_.strength();
    if (acceleration > 0) guess = std::min(guess, speed / acceleration);
    return std::min(guess, ahead / speed);
  }

  void strike(int direction, Real speed) {
    const bool upper = direction > 0;
    run_.impacts.push_back({static_cast<double>(time_), upper ? Wall::upper : Wall::lower,
                            static_cast<double>(speed)});
    if (scene_.rule == CountRule::impacts && speed > scene_.counting_limit) ++run_.count;
    below_ = upper ? gap_ : 0;
    above_ = upper ? 0 : gap_;
    Real restitution = upper ? scene_.restitution_upper : scene_.restitution_lower;
    if (scene_.contact_friction) {
      const Real mu = scene_.friction;
      restitution *= std::sqrt((1 - mu) / (1 + mu));
    }
    velocity_ = -direction * restitution * speed;
    if (!comes_to_rest(direction, restitution * speed, restitution)) return;
    // The omitted maxima lie on the upper wall, or arbitrarily close to the lower one.
    const Real wall = upper ? scene_.wall_upper : scene_.wall_lower;
    if (scene_.rule == CountRule::peaks && velocity_ != 0 && counted(wall) > 0) {
      run_.endless = true;
    }
    velocity_ = 0;
  }

  /// Returns true if it is proved that a body that leaves the wall in `wall_side` at `speed`
  /// bounces until it rests there, never faster. Suppose that the pressing acceleration p stays
  /// within slack of its value. A rebound then rises against at least p - slack + friction, so no
  /// higher than h = v^2 / (2 (p - slack + friction)), and falls from there by at most p + slack -
  /// friction and at least p - slack - friction. That bounds the ratio of speeds and the time of
  /// all rebounds; and if the force cannot change by more than the slack in that time, the
  /// supposition holds.
  bool comes_to_rest(int wall_side, Real speed, Real restitution) const {
    if (speed > 1e-3L * scene_.counting_limit) return false;
    const Real press = wall_side * From(push_, time_).after(0).acceleration;
    const Real reserve = press - friction_;
    if (reserve <= 64 * acceleration_noise_) return false;
    const Real steady_ratio = restitution * std::sqrt(reserve / (press + friction_));
    const Real slack = reserve * (1 - steady_ratio) / 2;
    const Real rise = press - slack + friction_;
    const Real slowest_fall = reserve - slack;
    const Real ratio = restitution * std::sqrt((reserve + slack) / rise);
    if (!(ratio < 1)) return false;
    const Real hop = speed / rise + speed / std::sqrt(rise * slowest_fall);
    const bool in_time = scene_.rule == CountRule::impacts || hop / (1 - ratio) < window_ - time_;
    const bool smooth = hop / (1 - ratio) < push_.smooth_until(time_) - time_;
    return in_time && smooth && bound_[1] * hop / (1 - ratio) <= slack;
  }

  const Scene& scene_;
  const Force push_;
  const Real friction_;          // [m/s^2]
  const Real window_;            // [s]
  const Real gap_;               // [m]
  std::array<Real, 4> bound_{};  // on the derivatives of the push within the window
  Real acceleration_noise_ = 0;
  Real jerk_noise_ = 0;

  Real time_ = 0;
  Real horizon_ = 0;  // [s], until when From tells the motion of a flight or rest that starts now
  int flights_ = 0;
  Real below_, above_;  // distance [m] to each wall, stored apart to keep all digits
  Real velocity_;
  std::optional<Top> top_;  // turning point of a rising body, until it moves on
  OracleRun run_;
};

}  // namespace ricochet::carrier_track::inline oracle::of_body
