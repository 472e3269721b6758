#include "problems/carrier_track/check/oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "problems/carrier_track/check/first_fall.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track::inline oracle {

namespace {

using Real = long double;

constexpr Real last_bit = std::numeric_limits<Real>::epsilon();
constexpr int flight_cap = 20 * static_cast<int>(oracle_impact_cap);

Real window_of(const Scene& scene) {
  const auto* turns = std::get_if<Revolutions>(&scene.window);
  if (turns == nullptr || !scene.profile.empty()) return duration_of(scene);
  return 2 * std::numbers::pi_v<Real> * turns->count / scene.omega;
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

class Body {
 public:
  /// All of the scene but its applied forces.
  Body(const Scene& scene, const Push& push)
      : scene_(scene),
        push_(push),
        friction_(static_cast<Real>(scene.friction) * scene.normal_force / scene.mass),
        window_(window_of(scene)),
        gap_(static_cast<Real>(scene.wall_upper) - scene.wall_lower),
        below_(static_cast<Real>(scene.start_position) - scene.wall_lower),
        above_(static_cast<Real>(scene.wall_upper) - scene.start_position),
        velocity_(scene.start_velocity) {
    const Real operations = 16;
    acceleration_noise_ = last_bit * operations * friction_ + push_.noise(0);
    jerk_noise_ = push_.noise(1);
    for (std::size_t i = 0; i < bound_.size(); ++i) {
      bound_[i] = push_.bound(static_cast<int>(i));
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
    const PushFrom push(push_, time_);
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
    const PushFrom push(push_, time_);
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
    const Real press = wall_side * PushFrom(push_, time_).after(0).acceleration;
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
  const Push& push_;
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

}  // namespace

OracleRun oracle_run(const Scene& scene) {
  return oracle_run(scene, Push(applied_force(scene), scene.mass, window_of(scene)));
}

OracleRun oracle_run(const Scene& scene, const Push& push) {
  return Body(scene, push).run();
}

namespace {

std::vector<Impact> counted(std::vector<Impact> impacts, const Scene& scene) {
  std::erase_if(impacts, [&](const Impact& i) { return !(i.speed > scene.counting_limit); });
  return impacts;
}

std::vector<Peak> counted(std::vector<Peak> maxima, const Scene& scene) {
  std::erase_if(maxima, [&](const Peak& peak) {
    return !(peak.position > scene.peak_high || peak.position < scene.peak_low);
  });
  return maxima;
}

/// Pairs the impacts of both lists.
void match(const std::vector<Impact>& found, const std::vector<Impact>& true_ones,
           Comparison& result) {
  const std::size_t pairs = std::min(found.size(), true_ones.size());
  for (std::size_t k = 0; k < pairs && found[k].wall == true_ones[k].wall; ++k) {
    ++result.matched;
    result.time_error = std::max(result.time_error, std::abs(found[k].time - true_ones[k].time));
    result.speed_error =
        std::max(result.speed_error, std::abs(found[k].speed - true_ones[k].speed));
  }
  result.missed = static_cast<int>(true_ones.size()) - result.matched;
  result.spurious = static_cast<int>(found.size()) - result.matched;
}

/// The same for maxima, without errors: the time of a flat maximum is ill-conditioned.
void match(const std::vector<Peak>& found, const std::vector<Peak>& true_ones, Comparison& result) {
  result.matched = static_cast<int>(std::min(found.size(), true_ones.size()));
  result.missed = static_cast<int>(true_ones.size()) - result.matched;
  result.spurious = static_cast<int>(found.size()) - result.matched;
}

}  // namespace

Comparison compare(const Scene& scene) {
  Comparison result;
  const OracleRun true_values = oracle_run(scene);
  if (!true_values.finished) {
    result.compared = false;
    return result;
  }
  const Recording recording = record(scene, 0.0, 0);
  result.certain = recording.certainty.certain;
  result.count = recording.count;
  result.true_values = true_values.count;
  result.endless = true_values.endless;
  if (scene.rule == CountRule::impacts) {
    match(counted(recording.impacts, scene), counted(true_values.impacts, scene), result);
  } else {
    match(counted(recording.peaks, scene), counted(true_values.maxima, scene), result);
  }
  return result;
}

}  // namespace ricochet::carrier_track::inline oracle
