// For tools that integrate ordinary differential equations and find roots of functions: the motion
// of a scene from one event to the next.
#pragma once

#include "tool.h"

namespace impact_test {

/// Between events the body flies, with friction against its direction, or it rests.
///
/// A driver integrates rates() from `time` and `state`, at most until end(), while all of values()
/// stay positive: one that falls through zero is an event. It then calls proceed() with the state
/// there. Values start at zero after an impact: only falling through zero is an event.
class Motion {
 public:
  using State = std::array<double, 2>;  ///< position [m], velocity [m/s]
  static constexpr int values_count = 3;
  using Values = std::array<double, values_count>;

  /// A body that leaves a wall while a force holds it there rests, if the height of its flight is
  /// lost in the tool's tolerance, relative to the clearance, and if its impacts are not scored; or
  /// if the height is lost in rounding.
  Motion(const Scene& scene, double tolerance)
      : state{scene.position, scene.velocity}, scene_(scene) {
    const double farthest = std::max(std::abs(scene.lower), std::abs(scene.lower + scene.length()));
    const double rounding = 1e3 * std::numeric_limits<double>::epsilon() * farthest;
    rest_speed_ = std::max(std::min(std::sqrt(tolerance) * scene.speed(), scene.slowest / 4),
                           std::sqrt(2 * rounding * scene.largest_force() / scene.mass));
    settle(false);
  }

  double time = 0;
  State state;
  Result result;

  bool over() const { return time >= scene_.duration; }
  double end() const { return scene_.end_of(segment_); }

  void rates(double t, const double* y, double* rates) const {
    rates[0] = moves_ ? y[1] : 0;
    rates[1] = moves_ ? (force(t) - direction_ * scene_.friction) / scene_.mass : 0;
  }

  /// In flight: the distances from the walls, and the speed if there is friction. At rest: what is
  /// missing to a force that moves the body. 1 for what does not exist.
  Values values(double t, const double* y) const {
    if (!moves_) return {hold(t), 1, 1};
    return {y[0] - scene_.lower, scene_.upper < infinity ? scene_.upper - y[0] : 1,
            scene_.friction > 0 ? direction_ * y[1] : 1};
  }

  /// To the event `which` at time t and state y; -1: to end(), without an event.
  void proceed(double t, const double* y, int which) {
    if (which < 0 || end() - t < shortest_span) t = end();
    at_once_ = t - time < at_once ? at_once_ + 1 : 0;
    if (at_once_ > most_at_once) throw std::runtime_error("the tool finds one event for ever");
    time = t;
    state = {y[0], y[1]};
    if (time == end() && !over()) ++segment_;
    const bool released = !moves_ && which >= 0;
    if (moves_ && which >= 0) arrive(which);
    if (!moves_ || which >= 0) settle(released);
    result.end = state;
  }

  /// At rest that of the scene; in flight no longer than the clearance takes at full speed [s].
  double longest_step() const {
    const double longest = scene_.longest_step();
    return moves_ ? std::min(longest, scene_.length() / scene_.speed()) : longest;
  }

  /// A first step that ends before the body can be back at the wall [s]: functions that start at
  /// zero are then positive at its end. After an event at the start it is shorter each time.
  double first_step() const {
    const double flight =
        std::abs(state[1]) * scene_.mass / (std::abs(force(time)) + scene_.friction + 1e-300);
    const double step = std::min(flight > 0 ? flight / 5 : infinity, longest_step() / 10);
    return step * std::pow(0.1, std::min(at_once_, 8));
  }

 private:
  static constexpr double shortest_span = 1e-12;  // [s], that tools integrate
  static constexpr double at_once = 1e-10;        // [s]
  static constexpr int most_at_once = 100;

  double force(double t) const { return scene_.segments[segment_].force(t); }
  bool at_lower() const { return state[0] <= scene_.lower; }
  bool at_upper() const { return state[0] >= scene_.upper; }

  /// At rest: how much force is missing to one that moves the body [N].
  double hold(double t) const {
    const double f = force(t);
    return scene_.friction - (at_lower() ? f : at_upper() ? -f : std::abs(f));
  }

  void arrive(int which) {
    if (which == 2) {
      state[1] = 0;
      return;
    }
    const bool upper = which == 1;
    const double speed = upper ? state[1] : -state[1];
    state[0] = upper ? scene_.upper : scene_.lower;
    if (speed > 0) {
      result.impacts.push_back({time, upper, speed});
      state[1] *= -(upper ? scene_.restitution_upper : scene_.restitution_lower);
    }
    // Where a tool sees a body cross a wall on its way back, it cannot resolve a speed as slow.
    const bool is_slow = speed <= 0 || std::abs(state[1]) < rest_speed_;
    if (is_slow && hold(time) >= 0) state[1] = 0;
  }

  /// Whether the body moves now, and in which direction. It does where a root of hold() is found.
  void settle(bool released) {
    moves_ = released || state[1] != 0 || hold(time) < 0;
    if (moves_) direction_ = (state[1] != 0 ? state[1] : force(time)) > 0 ? 1 : -1;
  }

  const Scene& scene_;
  double rest_speed_;
  std::size_t segment_ = 0;
  bool moves_ = true;
  double direction_ = 1;  // of the velocity, in flight
  int at_once_ = 0;       // events, one after another
};

}  // namespace impact_test
