#include "problems/carrier_track/check/integrator.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "ricochet/machine.h"

namespace ricochet::carrier_track::inline reference_integrators {

std::vector<Integrator> all_integrators() {
  return {
      event_driven(),        odeint_dopri5(), odeint_rosenbrock4(),
#ifdef RICOCHET_HAS_SUNDIALS
      cvode_adams(),         cvode_bdf(),
#endif
      semi_implicit_euler(), runge_kutta_4(), moreau_jean(),
  };
}

std::vector<Integrator> penalty_integrators() {
  return {
      event_driven(),
      penalty_odeint_dopri5(),
      penalty_odeint_rosenbrock4(),
#ifdef RICOCHET_HAS_SUNDIALS
      penalty_cvode_adams(),
      penalty_cvode_bdf(),
#endif
      penalty_semi_implicit_euler(),
      penalty_runge_kutta_4(),
  };
}

std::vector<std::string> missing_integrators() {
#ifdef RICOCHET_HAS_SUNDIALS
  return {};
#else
  return {"cvode-adams", "cvode-bdf"};
#endif
}

namespace {

std::vector<Impact> faster_than(double speed, const Outcome& outcome) {
  std::vector<Impact> chosen;
  std::copy_if(outcome.impacts.begin(), outcome.impacts.end(), std::back_inserter(chosen),
               [&](const Impact& impact) { return impact.speed > speed; });
  return chosen;
}

}  // namespace

int collisions(const Scene& scene, const Outcome& outcome) {
  return static_cast<int>(faster_than(scene.counting_limit, outcome).size());
}

Accuracy compare(const Scene& scene, const Outcome& outcome, const Outcome& reference) {
  Accuracy accuracy;
  const int expected = collisions(scene, reference);
  accuracy.count_difference = collisions(scene, outcome) - expected;
  accuracy.end_position_error = std::abs(outcome.end.position - reference.end.position);
  const double window = 0.5 * duration_of(scene) / std::max(expected, 1);
  const std::vector<Impact> seen = faster_than(0.5 * scene.counting_limit, outcome);
  const std::vector<Impact> real = faster_than(0.5 * scene.counting_limit, reference);
  auto s = seen.begin();
  auto r = real.begin();
  while (s != seen.end() || r != real.end()) {
    const bool both = s != seen.end() && r != real.end();
    if (both && s->wall == r->wall && std::abs(s->time - r->time) <= window) {
      if (accuracy.missed + accuracy.spurious == 0) {
        ++accuracy.matched;
        accuracy.impact_time_error =
            std::max(accuracy.impact_time_error.value_or(0.0), std::abs(s->time - r->time));
      }
      ++s;
      ++r;
    } else if (r == real.end() || (both && s->time < r->time)) {
      accuracy.spurious += (s++)->speed > scene.counting_limit;
    } else {
      accuracy.missed += (r++)->speed > scene.counting_limit;
    }
  }
  return accuracy;
}

namespace {

class ImpactCollector : public Observer {
 public:
  explicit ImpactCollector(std::vector<Impact>& impacts) : impacts_(impacts) {}

  void impact(double time, Wall wall, double speed) {
    if (impacts_.size() == most_impacts) throw std::runtime_error("more than 1000000 impacts");
    impacts_.push_back({time, wall, speed});
  }

 private:
  std::vector<Impact>& impacts_;
};

Outcome run_event_driven(const Scene& scene, double /*control*/) {
  Outcome outcome;
  ImpactCollector collector(outcome.impacts);
  try {
    const bool compliant = scene.fidelity == Fidelity::compliant && scene.profile.empty();
    const End<double> end = compliant ? CompliantModel(scene, 1e-12).run(collector)
                                      : simulate_at_needed_fidelity(scene, collector);
    outcome.end = {end.time, end.position, end.velocity};
    outcome.force_evaluations = end.evaluations;
    outcome.finished = true;
  } catch (const std::runtime_error& error) {
    outcome.failure = error.what();
  }
  return outcome;
}

}  // namespace

Integrator event_driven() {
  return {"event-driven", "ricochet " RICOCHET_VERSION, "none", run_event_driven};
}

namespace {

/// [m/s]; slowest_rebound, or more if the height v^2 / (2 a) under the largest force would be lost
/// in the rounding of the position: impacts would then go on forever.
double slowest_resolved(const Scene& scene, const Forces& forces) {
  const double force = forces.strongest() + forces.friction;
  const double farthest =
      std::max(std::abs(scene.wall_lower),
               std::isfinite(scene.wall_upper) ? std::abs(scene.wall_upper) : 0.0);
  const double rounding = 32 * std::numeric_limits<double>::epsilon() * farthest;
  return std::max(slowest_rebound, std::sqrt(2 * force * rounding));
}

class HybridMotion {
 public:
  HybridMotion(const Scene& scene, FlightMethod& method)
      : scene_(scene),
        forces_(forces_of(scene)),
        method_(method),
        duration_(duration_of(scene)),
        slowest_(slowest_resolved(scene, forces_)),
        state_{scene.start_position, scene.start_velocity} {
    if (state_.position == scene.wall_lower) wall_ = Wall::lower;
    if (state_.position == scene.wall_upper) wall_ = Wall::upper;
    direction_ = (state_.velocity > 0) - (state_.velocity < 0);
    if (direction_ == 0) direction_ = direction_of_release();
  }

  Outcome run() {
    try {
      while (time_ < duration_) direction_ == 0 ? rest() : move();
      outcome_.finished = true;
    } catch (const std::runtime_error& error) {
      outcome_.failure = error.what();
    }
    outcome_.end = {time_, state_.position, state_.velocity};
    outcome_.force_evaluations = evaluations_ + method_.evaluations();
    return std::move(outcome_);
  }

 private:
  double applied(double time) {
    ++evaluations_;
    return forces_.applied(time);
  }

  /// Excess of the applied force over friction towards a side without a wall [m/s^2].
  double excess(double push) const {
    const double up = wall_ == Wall::upper ? -std::numeric_limits<double>::infinity() : push;
    const double down = wall_ == Wall::lower ? -std::numeric_limits<double>::infinity() : -push;
    return std::max(up, down) - forces_.friction;
  }

  int direction_of_release() {
    const double push = applied(time_);
    return excess(push) > 0 ? (push > 0) - (push < 0) : 0;
  }

  void move() {
    const double wall = direction_ > 0 ? scene_.wall_upper : scene_.wall_lower;
    if (state_.position == wall) return strike();
    wall_.reset();
    const Landing landing = method_.fly({time_, state_, direction_, duration_ - time_});
    state_ = landing.state;
    if (landing.finish == Finish::limit) {
      time_ = duration_;
      return;
    }
    time_ += landing.duration;
    if (landing.finish == Finish::turn) {
      state_.velocity = 0;
      direction_ = direction_of_release();
      return;
    }
    direction_ = landing.finish == Finish::upper_wall ? +1 : -1;
    strike();
  }

  void strike() {
    if (outcome_.impacts.size() == most_impacts) {
      throw std::runtime_error("more than 1000000 impacts");
    }
    wall_ = direction_ > 0 ? Wall::upper : Wall::lower;
    const double speed = std::max(0.0, direction_ * state_.velocity);
    outcome_.impacts.push_back({time_, *wall_, speed});
    const double rebound =
        speed * (direction_ > 0 ? upper_restitution(scene_) : lower_restitution(scene_));
    const int into = direction_;
    state_.position = direction_ > 0 ? scene_.wall_upper : scene_.wall_lower;
    direction_ = -direction_;
    state_.velocity = direction_ * rebound;
    if (rebound <= slowest_ && into * applied(time_) >= -forces_.friction) {
      state_.velocity = 0;
      direction_ = 0;
    }
  }

  void rest() {
    const double interval = forces_.shortest_period() / 64;
    while (time_ < duration_) {
      if (++samples_ > most_steps) throw std::runtime_error("more than 1000000 samples at rest");
      const double next = std::min(time_ + interval, duration_);
      const double push = applied(next);
      if (excess(push) > 0) {
        time_ = rise([&](double t) { return excess(applied(t)); }, time_, next);
        direction_ = push > 0 ? +1 : -1;
        return;
      }
      time_ = next;
    }
  }

  const Scene& scene_;
  Forces forces_;
  FlightMethod& method_;
  double duration_;  // [s]
  double slowest_;   // [m/s], of a rebound
  double time_ = 0;  // [s]
  State state_;
  int direction_ = 0;         // of motion; 0 at rest
  std::optional<Wall> wall_;  // the wall touched
  std::int64_t samples_ = 0;
  std::int64_t evaluations_ = 0;
  Outcome outcome_;
};

}  // namespace

FlightSetting flight_setting(const Scene& scene) {
  double length = scene.wall_upper - scene.wall_lower;
  if (!std::isfinite(length)) length = scene.start_position - scene.wall_lower;
  return {forces_of(scene),
          {scene.wall_lower, scene.wall_upper},
          duration_of(scene),
          length > 0 ? length : 1.0};
}

Outcome run_with_located_events(const Scene& scene, FlightMethod& method) {
  return HybridMotion(scene, method).run();
}

}  // namespace ricochet::carrier_track::inline reference_integrators
