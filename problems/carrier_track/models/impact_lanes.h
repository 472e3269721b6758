#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <vector>

#include "problems/carrier_track/models/impact_model.h"
#include "problems/carrier_track/models/lanes.h"
#include "ricochet/recording.h"
#include "src/core/time_limit.h"

namespace ricochet::carrier_track::inline models {

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
      : model_at_(model_at), observer_at_(observer_at), outcomes_(size) {}

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
