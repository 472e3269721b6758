#include "problems/carrier_track/check/walls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "src/core/bracketed_root.h"

namespace ricochet::carrier_track::inline reference_integrators {

StepPlan equal_steps(double window, double longest) {
  const double count = std::ceil(window / longest);
  if (!(count <= static_cast<double>(most_fixed_steps))) {
    throw std::runtime_error("more than 100000000 steps");
  }
  return {static_cast<std::int64_t>(count), window / count};
}

namespace {

/// Adds the impact of a body that arrives at a wall, and returns the speed of its rebound.
double strike(const Scene& scene, Outcome& outcome, double time, Wall wall, double speed) {
  add_impact(outcome, time, wall, speed);
  return speed * (wall == Wall::upper ? upper_restitution(scene) : lower_restitution(scene));
}

/// Carries out the steps of a run. What they throw is its failure; what it has by then stays.
template <class Steps>
void carry_out(const Steps& steps, const System& system, Outcome& outcome) {
  try {
    steps();
  } catch (const std::runtime_error& error) {
    outcome.failure = error.what();
  }
  outcome.force_evaluations = system.forces.evaluations();
}

/// The motion between hard walls with the flights of a method.
class HybridMotion {
 public:
  HybridMotion(const Scene& scene, const MakeMethod& make, double tolerance)
      : scene_(scene),
        system_(scene),
        method_(make(system_, tolerance)),
        state_{scene.start_position, scene.start_velocity} {
    // [m/s]; slowest_rebound, or more if the height v^2 / (2 a) under the largest force would be
    // lost in the rounding of the position: impacts would then go on forever.
    const double force = system_.forces.strongest() + system_.friction;
    const double farthest = std::max(std::abs(system_.lower),
                                     std::isfinite(system_.upper) ? std::abs(system_.upper) : 0.0);
    const double rounding = 32 * std::numeric_limits<double>::epsilon() * farthest;
    slowest_ = std::max(slowest_rebound, std::sqrt(2 * force * rounding));
    if (state_.position == system_.lower) wall_ = Wall::lower;
    if (state_.position == system_.upper) wall_ = Wall::upper;
    set_direction();
  }

  Outcome run() {
    const auto steps = [this] {
      while (time_ < system_.window) direction_ == 0 ? rest() : move();
    };
    carry_out(steps, system_, outcome_);
    outcome_.end = {time_, state_.position, state_.velocity};
    return std::move(outcome_);
  }

 private:
  /// Excess of the applied force over friction towards a side without a wall [m/s^2].
  double excess(double push) const {
    constexpr double none = -std::numeric_limits<double>::infinity();
    const double up = wall_ == Wall::upper ? none : push;
    const double down = wall_ == Wall::lower ? none : -push;
    return std::max(up, down) - system_.friction;
  }

  /// That of the velocity; of a body at rest that of the force if it exceeds friction.
  void set_direction() {
    direction_ = (state_.velocity > 0) - (state_.velocity < 0);
    if (direction_ != 0) return;
    const double push = system_.forces.applied(time_);
    if (excess(push) > 0) direction_ = (push > 0) - (push < 0);
  }

  void move() {
    if (state_.position == (direction_ > 0 ? system_.upper : system_.lower)) return strike();
    wall_.reset();
    const double end = std::min(system_.forces.smooth_until(time_), system_.window);
    const Landing landing = method_->fly({time_, state_, direction_, end - time_});
    state_ = landing.state;
    time_ = landing.finish == Finish::limit ? end : time_ + landing.duration;
    if (landing.finish == Finish::turn) state_.velocity = 0;
    if (landing.finish == Finish::turn || landing.finish == Finish::limit) return set_direction();
    direction_ = landing.finish == Finish::upper_wall ? +1 : -1;
    strike();
  }

  void strike() {
    const int into = direction_;
    wall_ = into > 0 ? Wall::upper : Wall::lower;
    const double speed = std::max(0.0, into * state_.velocity);
    const double rebound = reference_integrators::strike(scene_, outcome_, time_, *wall_, speed);
    state_ = {into > 0 ? system_.upper : system_.lower, -into * rebound};
    direction_ = -into;
    if (rebound <= slowest_ && into * system_.forces.applied(time_) >= -system_.friction) {
      state_.velocity = 0;
      direction_ = 0;
    }
  }

  void rest() {
    const double interval = system_.forces.shortest_period() / 64;
    while (time_ < system_.window) {
      if (++samples_ > most_steps) throw std::runtime_error("more than 1000000 samples at rest");
      const double next = std::min(time_ + interval, system_.window);
      const double push = system_.forces.applied(next);
      if (excess(push) > 0) {
        time_ = departure(time_, next);
        direction_ = push > 0 ? +1 : -1;
        return;
      }
      time_ = next;
    }
  }

  /// When the excess becomes positive, to a few roundings, if it is so at `upper` [s].
  double departure(double lower, double upper) const {
    const auto f = [this](double t) { return excess(system_.forces.applied(t)); };
    const double at_lower = f(lower);
    if (at_lower >= 0) return lower;
    const double width = 4 * std::numeric_limits<double>::epsilon() * upper;
    return bracketed_root(f, lower, upper, at_lower, f(upper),
                          [width](double a, double b) { return b - a <= width; })
        .second;
  }

  const Scene& scene_;
  System system_;
  std::unique_ptr<Method> method_;
  double slowest_;   // [m/s], of a rebound
  double time_ = 0;  // [s]
  State state_;
  int direction_ = 0;         // of motion; 0 at rest
  std::optional<Wall> wall_;  // the wall touched
  std::int64_t samples_ = 0;
  Outcome outcome_;
};

/// Equal steps between hard walls.
void reflect(const Scene& scene, System& system, double longest, Rule rule, Outcome& outcome) {
  const auto [count, h] = equal_steps(system.window, longest);
  const Forces& forces = system.forces;
  State state{scene.start_position, scene.start_velocity};
  outcome.end = {0, state.position, state.velocity};
  for (std::int64_t i = 0; i < count; ++i) {
    const double start = static_cast<double>(i) * h;
    const double time = static_cast<double>(i + 1) * h;
    system.direction = (state.velocity > 0) - (state.velocity < 0);
    if (system.direction == 0) {
      const double push = forces.applied(start);
      if (push > system.friction && state.position < system.upper) system.direction = +1;
      if (push < -system.friction && state.position > system.lower) system.direction = -1;
    }
    system.start = start;
    if (system.direction != 0) state = rule(system, 0, state, h);
    const int behind = (state.position > system.upper) - (state.position < system.lower);
    const double speed = behind * state.velocity;
    if (behind != 0) state.position = behind > 0 ? system.upper : system.lower;
    outcome.end = {time, state.position, state.velocity};
    if (behind == 0 || speed < 0) continue;  // it was back within the step
    const double rebound =
        strike(scene, outcome, time, behind > 0 ? Wall::upper : Wall::lower, speed);
    const double press = behind * forces.applied(time);
    const bool rests = press >= -system.friction &&
                       rebound <= std::max(slowest_rebound, h * (press + system.friction));
    state.velocity = outcome.end.velocity = rests ? 0.0 : -behind * rebound;
  }
}

Outcome run_with_reflection(const Scene& scene, double longest, Rule rule) {
  Outcome outcome;
  System system(scene);
  carry_out([&] { reflect(scene, system, longest, rule, outcome); }, system, outcome);
  return outcome;
}

/// The motion through the contacts of compliant walls.
class MotionThroughWalls {
 public:
  /// `gap` [m]: a body that is deeper in a wall ends the run.
  MotionThroughWalls(const Scene& scene, const System& system, double gap, const MakeMethod& make,
                     double setting)
      : system_(system),
        gap_(gap),
        scales_speed_(!scene.contact_speed),
        method_(make(system_, setting)),
        state_{scene.start_position, scene.start_velocity} {
    method_->start(state_);
  }

  Outcome run(std::int64_t most) {
    const auto steps = [this, most] {
      for (std::int64_t step = 1; time_ < system_.window; ++step) {
        if (step > most) throw std::runtime_error("more than " + std::to_string(most) + " steps");
        advance();
      }
    };
    carry_out(steps, system_, outcome_);
    outcome_.end = {time_, state_.position, state_.velocity};
    return std::move(outcome_);
  }

 private:
  /// The state before a contact.
  struct Entry {
    double time;
    double speed;
  };

  void advance() {
    if (scales_speed_ && !entry_) {
      system_.wall->speed = std::max(std::abs(state_.velocity), resting_speed);
    }
    const double time = std::min(method_->step(), system_.window);
    const State state = method_->at(time);
    const double depth = system_.wall->depth(state.position);
    if (!std::isfinite(state.position) || !std::isfinite(state.velocity) || depth > gap_) {
      outcome_.deepest = std::numeric_limits<double>::infinity();
      throw std::runtime_error("the body has left the walls by more than the gap");
    }
    outcome_.deepest = std::max(outcome_.deepest, depth);
    if (depth > 0 && !entry_) enter(time, state);
    if (depth <= 0 && entry_) leave(time, state);
    time_ = time;
    state_ = state;
  }

  void enter(double time, const State& inside) {
    entry_ = Entry{time_, std::abs(state_.velocity)};
    const Wall wall = inside.position > system_.upper ? Wall::upper : Wall::lower;
    const int into = wall == Wall::upper ? +1 : -1;
    const double distance = std::max(
        0.0, -into * (state_.position - (wall == Wall::upper ? system_.upper : system_.lower)));
    const double before = into * state_.velocity;
    const double push = into * system_.forces.applied(time_);
    const double square = before * before + 2 * push * distance;
    const double speed = square > 0 ? std::sqrt(square) : std::max(before, into * inside.velocity);
    const double duration = before + speed > 0 ? 2 * distance / (before + speed) : time - time_;
    if (speed > 0) add_impact(outcome_, std::min(time_ + duration, time), wall, speed);
  }

  void leave(double time, const State& outside) {
    const double added = system_.forces.strongest() * (time - entry_->time);
    const double gained = std::abs(outside.velocity) - entry_->speed - added;
    outcome_.gained = std::max(outcome_.gained.value_or(gained), gained);
    entry_.reset();
  }

  System system_;
  double gap_;  // [m]
  bool scales_speed_;
  std::unique_ptr<Method> method_;
  double time_ = 0;  // [s]
  State state_;
  std::optional<Entry> entry_;  // while in a wall
  Outcome outcome_;
};

/// A rule of equal steps as a method for motion through compliant walls.
class EqualSteps : public Method {
 public:
  EqualSteps(System& system, double longest, Rule rule)
      : Method(system), length_(equal_steps(system.window, longest).length), rule_(rule) {}

  void start(const State& state) override { state_ = state; }
  double step() override {
    state_ = rule_(system_, static_cast<double>(steps_) * length_, state_, length_);
    const double time = static_cast<double>(++steps_) * length_;
    // Rounding may leave the last step just before the window's end.
    return system_.window - time < 0.5 * length_ ? system_.window : time;
  }
  State at(double /*time*/) override { return state_; }

 private:
  double length_;  // [s]
  Rule rule_;
  State state_{};
};

Outcome through_compliant_walls(const Scene& scene, const MakeMethod& make, double setting,
                                std::int64_t most) {
  if (scene.friction * scene.normal_force > 0) {
    throw std::runtime_error("through compliant walls there is no friction here");
  }
  const System system(scene);
  return MotionThroughWalls(scene, system, system.length, make, setting).run(most);
}

/// Of a wall that pulls at a body that leaves it: the ratio of speeds is exp(-pi z / sqrt(1 -
/// z^2)).
double damping_of(double restitution) {
  return restitution > 0 ? damping_ratio(restitution, Release::zero_depth) : 1;
}

Outcome through_springs(const Scene& scene, const MakeMethod& make, double depth) {
  if (scene.fidelity == Fidelity::compliant) throw std::runtime_error("the walls must be hard");
  System system(scene);
  const double gap = system.length;
  const double speed =  // that the forces give over the clearance, or that of the start
      std::max(std::abs(scene.start_velocity), std::sqrt(2 * system.forces.strongest() * gap));
  system.length = depth * gap;
  system.creep = depth * speed;
  const double frequency = speed / system.length;
  WallForce& wall = system.wall.emplace();
  wall.lower = system.lower;
  wall.upper = system.upper;
  wall.stiffness = frequency * frequency;
  wall.viscous = wall.pulls = true;
  wall.lower_damping = 2 * frequency * damping_of(lower_restitution(scene));
  wall.upper_damping = 2 * frequency * damping_of(upper_restitution(scene));
  return MotionThroughWalls(scene, system, gap, make, 0.1 * depth).run(most_steps);
}

bool compliant(const Scene& scene) {
  return scene.fidelity == Fidelity::compliant;
}

}  // namespace

Integrator adaptive(const char* name, const char* version, const char* title, MakeMethod make) {
  const auto run = [make = std::move(make)](const Scene& scene, double tolerance) {
    return compliant(scene) ? through_compliant_walls(scene, make, tolerance, most_steps)
                            : HybridMotion(scene, make, tolerance).run();
  };
  return measured(
      {name, version, title, "event location", by_tolerance, {1e-4, 1e-6, 1e-12}, true, run});
}

Integrator stepped(const char* name, const char* title, Rule rule) {
  const auto make = [rule](System& system, double longest) {
    return std::make_unique<EqualSteps>(system, longest, rule);
  };
  const auto run = [rule, make](const Scene& scene, double longest) {
    return compliant(scene) ? through_compliant_walls(scene, make, longest, most_fixed_steps)
                            : run_with_reflection(scene, longest, rule);
  };
  return measured({name,
                   "ricochet " RICOCHET_VERSION,
                   title,
                   "time stepping",
                   by_step,
                   {1.0 / 240, 1e-3, 1e-4},
                   true,
                   run});
}

Integrator with_springs(const char* name, const char* version, const char* title, MakeMethod make) {
  const auto run = [make = std::move(make)](const Scene& scene, double depth) {
    return through_springs(scene, make, depth);
  };
  return measured({name, version, title, "penalty", by_depth, {1e-2, 1e-3, 1e-4}, false, run});
}

}  // namespace ricochet::carrier_track::inline reference_integrators
