#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <type_traits>
#include <vector>

#include "problems/carrier_track/motion/forces.h"
#include "problems/carrier_track/motion/hard_wall_motion.h"
#include "problems/carrier_track/motion/lanes.h"
#include "problems/carrier_track/motion/profile_forces.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/machine.h"
#include "ricochet/scene.h"
#include "src/core/time_limit.h"

namespace ricochet::carrier_track::inline models {

/// Hard walls in one direction, event by event; see HardWallMotion, also for Scalar.
template <class Scalar, class Forces = AppliedForces<Scalar>>
class ImpactModel : HardWallMotion<Scalar, Forces> {
  using Base = HardWallMotion<Scalar, Forces>;
  using Base::direction_, Base::duration_, Base::time_, Base::velocity_, Base::wall_;

 public:
  /// `scene` must be valid (scene_check.h).
  explicit ImpactModel(const BasicScene<Scalar>& scene)
      : ImpactModel(scene, resting_speed_of(scene)) {}

  /// The same with another resting speed [m/s]: a search may use a higher one than the true
  /// objective.
  ImpactModel(const BasicScene<Scalar>& scene, double resting)
      : Base({scene.wall_lower, scene.wall_upper, lower_restitution(scene),
              upper_restitution(scene), scene.start_position, scene.start_velocity},
             Forces(scene), {scene.friction * scene.normal_force / scene.mass}, duration_of(scene),
             resting) {}

  /// Simulates the window once. Throws std::runtime_error past impact_limit impacts, and as
  /// check_time_limit() does.
  template <class SomeObserver>
  End<Scalar> run(SomeObserver& observer) {
    begin();
    for (std::uint32_t events = 0; goes_on(); ++events) {
      if (events % events_between_checks == 0) check_time_limit();
      step(observer);
    }
    return this->end();
  }

 private:
  template <class, class>
  friend class ImpactLanes;

  void begin() {
    if (direction_ == 0) direction_ = this->direction_of_release();
    if (direction_ == 0) velocity_ = constant<Scalar>(0.0);  // friction stops a body this slow
  }

  bool goes_on() const { return value(time_) < value(duration_); }

  /// Simulates up to the next event.
  template <class SomeObserver>
  [[gnu::always_inline]] void step(SomeObserver& observer) {
    if (direction_ == 0) {
      const auto rest = this->next_rest();
      this->rest(rest.time, this->after(rest.time), observer);
      direction_ = rest.direction;
    } else {
      move(observer);
    }
  }

  /// Handles the event that fly() found in the body's lane, or the next event if fly() found none.
  /// The model itself follows the lane only if the observer hears stretches.
  template <class SomeObserver>
  void follow(Lanes& lanes, std::size_t k, SomeObserver& observer) {
    const double event = lanes.event[k];
    if (event == Lanes::none) {
      this->leave(lanes, k);
      step(observer);
      this->enter(lanes, k);
      return;
    }
    const bool keeps_up = !SomeObserver::hears_impacts_alone && observer.hears_stretches();
    if (event == Lanes::rested) {
      if (keeps_up) this->rest_as_in(lanes, k, observer);
      direction_ = static_cast<int>(lanes.direction[k]);
      return;
    }
    const bool may_rest =
        event == Lanes::struck && std::abs(lanes.velocity[k]) <= this->resting_speed_;
    if (keeps_up) {
      const auto flight = this->flight();
      auto landing = flight;
      this->land(landing, lanes, k);
      finish(flight, landing,
             {event == Lanes::struck ? EventKind::wall : EventKind::turn, lanes.elapsed[k]},
             observer);
    } else {
      tell_event(lanes, k, observer);
      if (!may_rest) return;
      this->leave(lanes, k);
      rest_on_wall(observer);
    }
    if (may_rest) this->enter(lanes, k);
  }

  /// Reports the impact or turning point that ended the flight of a lane.
  template <class SomeObserver>
  [[gnu::always_inline]] void tell_event(const Lanes& lanes, std::size_t k,
                                         SomeObserver& observer) {
    constexpr bool turns_too = !SomeObserver::hears_impacts_alone;
    const double time = lanes.time[k];
    const double position = lanes.origin[k] + lanes.offset[k];
    if constexpr (turns_too) this->peaks_.moves(direction_, observer);
    if (lanes.event[k] == Lanes::struck) {
      count_impact(this->impacts_);
      observer.impact(time, lanes.wall[k] > 0 ? Wall::upper : Wall::lower, lanes.speed[k]);
    } else if constexpr (turns_too) {
      observer.turn(time, position, direction_ > 0 ? Wall::upper : Wall::lower);
    }
    if constexpr (turns_too) {
      this->peaks_.stops(time, position);
      direction_ = static_cast<int>(lanes.direction[k]);
    }
  }

  template <class SomeObserver>
  [[gnu::always_inline]] void move(SomeObserver& observer) {
    // NOTE: not const: GCC 12 would keep the flight in memory, and a simulation would take 10 %
    // longer.
    auto flight = this->flight();
    auto landing = flight;
    const auto end = this->advance_to_event(landing);
    finish(flight, landing, end, observer);
  }

  /// Lets a flight pass that ends with `end`.
  template <class SomeObserver>
  [[gnu::always_inline]] void finish(const typename Forces::Path& flight,
                                     const typename Forces::Path& landing,
                                     const typename Base::Ending& end, SomeObserver& observer) {
    this->pass(flight, landing, end.time, this->after(end.time), observer);
    if (end.kind == EventKind::turn) {
      this->stop(observer);
      direction_ = this->direction_of_release();
    } else if (end.kind == EventKind::wall) {
      this->strike(observer);
      rest_on_wall(observer);
    }
  }

  /// Stops a body that has struck a wall if its rebounds are a Zeno tail.
  template <class SomeObserver>
  [[gnu::always_inline]] void rest_on_wall(SomeObserver& observer) {
    const bool rebounds = value(velocity_) != 0;
    const std::optional<Scalar> hops = this->rest_after_hops();
    if (!hops) return;
    if (rebounds) observer.hops(time_, *wall_);
    this->rest(*hops, this->after(*hops), observer);
    direction_ = this->direction_of_release();
  }
};

/// The end of a simulation, or the exception that it threw.
struct LaneOutcome {
  End<double> end{};
  std::exception_ptr failure = nullptr;
};

/// Many simulations side by side; see run_in_lanes. The simulations in the lanes start together,
/// because similar scenes then do the same at the same time. The next ones start when the last of
/// them has ended.
template <class ModelAt, class ObserverAt>
class ImpactLanes {
 public:
  ImpactLanes(std::size_t size, const ModelAt& model_at, const ObserverAt& observer_at)
      : model_at_(model_at), observer_at_(observer_at), outcomes_(size) {
    using SomeObserver = std::remove_reference_t<std::invoke_result_t<ObserverAt, std::size_t>>;
    if (SomeObserver::hears_impacts_alone) lanes_.flights = 4;
  }

  std::vector<LaneOutcome> run() {
    while (next_ < outcomes_.size()) {
      fill();
      for (std::uint32_t events = 0; busy_ > 0; ++events) {
        if (events % events_between_checks == 0) check_time_limit();
        fly(lanes_);
        for (std::size_t k = 0; k < Lanes::size; ++k) {
          if (models_[k]) follow(k);
        }
      }
    }
    return std::move(outcomes_);
  }

 private:
  void fill() {
    lanes_.used = 0;
    for (std::size_t k = 0; k < Lanes::size && next_ < outcomes_.size(); ++k) {
      models_[k].emplace(model_at_(next_));
      // All models in the lanes must have the same number of harmonics.
      if (busy_ > 0 && models_[k]->harmonics() != lanes_.harmonics) {
        models_[k].reset();
        return;
      }
      lanes_.harmonics = models_[k]->harmonics();
      index_[k] = next_++;
      lanes_.used = k + 1;
      ++busy_;
      models_[k]->begin();
      models_[k]->enter(lanes_, k);
      lanes_.evaluations[k] = 0;
      if (!models_[k]->goes_on()) end(k);
    }
  }

  void follow(std::size_t k) {
    try {
      models_[k]->follow(lanes_, k, observer_at_(index_[k]));
    } catch (...) {
      outcomes_[index_[k]].failure = std::current_exception();
      end(k);
      return;
    }
    if (lanes_.time[k] >= lanes_.duration[k]) end(k);
  }

  void end(std::size_t k) {
    models_[k]->leave(lanes_, k);
    outcomes_[index_[k]].end = models_[k]->end();
    outcomes_[index_[k]].end.evaluations += static_cast<std::int64_t>(lanes_.evaluations[k]);
    models_[k].reset();
    lanes_.direction[k] = 0;
    --busy_;
  }

  const ModelAt& model_at_;
  const ObserverAt& observer_at_;
  std::vector<LaneOutcome> outcomes_;
  std::size_t next_ = 0;
  std::size_t busy_ = 0;
  Lanes lanes_;
  std::array<std::optional<ImpactModel<double>>, Lanes::size> models_;
  std::array<std::size_t, Lanes::size> index_{};  // of the simulation in a lane
};

/// Returns true if the simulation of a valid scene can run in lanes: hard walls at constant speed.
inline bool fits_lanes(const Scene& scene) {
  return scene.fidelity == Fidelity::impact && scene.profile.empty();
}

/// Gives the same bits as `model_at(i).run(observer_at(i))` for i = 0, 1, ..., size - 1, several
/// times as fast. `model_at` returns an ImpactModel<double>, `observer_at` a reference to its
/// observer. Similar scenes should be neighbours. Throws TimeLimitReached for all of them together.
template <class ModelAt, class ObserverAt>
std::vector<LaneOutcome> run_in_lanes(std::size_t size, const ModelAt& model_at,
                                      const ObserverAt& observer_at) {
  return ImpactLanes<ModelAt, ObserverAt>(size, model_at, observer_at).run();
}

}  // namespace ricochet::carrier_track::inline models
