#include "problems/carrier_track/check/penalty.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

#include "problems/carrier_track/check/fixed_step.h"
#include "problems/carrier_track/check/integrator.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track::inline reference_integrators {

namespace {

class PenaltyRun {
 public:
  explicit PenaltyRun(const Scene& scene)
      : system_(system_of(scene)), scale_speed_(!scene.contact_speed) {
    state_ = {scene.start_position, scene.start_velocity};
    strongest_ = std::abs(system_.forces.steady) + std::abs(system_.forces.turning) +
                 std::abs(system_.forces.disturbance);
  }

  Outcome run(const MakeStepMethod& make, double control, bool fixed) {
    std::unique_ptr<StepMethod> method;
    try {
      method = make(system_, control);
      for (std::int64_t steps = 1; time_ < system_.window; ++steps) {
        if (!fixed && steps > most_steps) throw std::runtime_error("more than 1000000 steps");
        advance(*method);
      }
      outcome_.finished = true;
    } catch (const std::runtime_error& error) {
      outcome_.failure = error.what();
    }
    outcome_.end = {time_, state_.position, state_.velocity};
    if (method) outcome_.force_evaluations += method->evaluations();
    return std::move(outcome_);
  }

 private:
  /// The state before a contact.
  struct Entry {
    double time;
    double speed;
  };

  static PenaltySystem system_of(const Scene& scene) {
    const FlightSetting setting = flight_setting(scene);
    return {setting.forces, wall_force_of(scene), setting.window, setting.length};
  }

  void advance(StepMethod& method) {
    if (scale_speed_ && !entry_) {
      system_.wall.speed = std::max(std::abs(state_.velocity), resting_speed);
    }
    double time = time_;
    State state = state_;
    method.step(time, state);
    const double depth = system_.wall.depth(state.position);
    if (!std::isfinite(state.position) || !std::isfinite(state.velocity) ||
        depth > system_.length) {
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
    if (outcome_.impacts.size() == most_impacts) {
      throw std::runtime_error("more than 1000000 impacts");
    }
    const Wall wall = inside.position > system_.wall.upper ? Wall::upper : Wall::lower;
    const int into = wall == Wall::upper ? +1 : -1;
    const double distance =
        std::max(0.0, -into * (state_.position -
                               (wall == Wall::upper ? system_.wall.upper : system_.wall.lower)));
    const double before = into * state_.velocity;
    const double push = into * system_.forces.applied(time_);
    ++outcome_.force_evaluations;
    const double square = before * before + 2 * push * distance;
    const double speed = square > 0 ? std::sqrt(square) : std::max(before, into * inside.velocity);
    const double duration = before + speed > 0 ? 2 * distance / (before + speed) : time - time_;
    if (speed > 0) outcome_.impacts.push_back({std::min(time_ + duration, time), wall, speed});
  }

  void leave(double time, const State& outside) {
    const double added = strongest_ * (time - entry_->time);
    const double gained = std::abs(outside.velocity) - entry_->speed - added;
    outcome_.gained = std::max(outcome_.gained.value_or(gained), gained);
    entry_.reset();
  }

  PenaltySystem system_;
  bool scale_speed_;
  double strongest_ = 0;  // [m/s^2], bound on the sum of the applied forces
  double time_ = 0;       // [s]
  State state_{};
  std::optional<Entry> entry_;  // while in a wall
  Outcome outcome_;
};

std::string termination_reason(const Scene& scene) {
  if (scene.fidelity != Fidelity::compliant) return "penalty methods need compliant walls";
  if (scene.friction * scene.normal_force > 0) return "penalty methods here have no friction";
  return {};
}

}  // namespace

Integrator penalty_integrator(std::string name, std::string version, std::string control,
                              MakeStepMethod method) {
  const bool fixed = control == "step [s]";
  return {std::move(name), std::move(version), std::move(control),
          [method = std::move(method), fixed](const Scene& scene, double value) {
            Outcome outcome;
            outcome.end = {0.0, scene.start_position, scene.start_velocity};
            outcome.failure = termination_reason(scene);
            return outcome.failure.empty() ? PenaltyRun(scene).run(method, value, fixed) : outcome;
          }};
}

double equal_steps(double window, double longest) {
  const double count = std::ceil(window / longest);
  if (!(count <= most_fixed_steps)) throw std::runtime_error("more than 100000000 steps");
  return window / count;
}

}  // namespace ricochet::carrier_track::inline reference_integrators
