#pragma once

#include <array>
#include <cstddef>
#include <exception>
#include <type_traits>
#include <vector>

#include "problems/carrier_track/counting/feature_trace.h"
#include "problems/carrier_track/models/impact_lanes.h"
#include "problems/carrier_track/models/simulate.h"
#include "ricochet/recording.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline counting {

/// A scene with its constants changed in the tenth digit, and its features.
struct Neighbour {
  /// A feature of this scene and one of the given scene are the same if their times differ by at
  /// most this share of the window. The window is longer by this share, so that features just after
  /// its end are seen.
  static constexpr double same_time = 1e-4;

  Scene scene;
  double end;  ///< [s], end of its window before it is made longer
  FeatureTrace trace;
  std::exception_ptr failure = nullptr;  ///< a std::runtime_error if the simulation fails

  /// `given` must be valid; stride and sign: see perturbed().
  Neighbour(const Scene& given, double stride, double sign);
  Neighbour(const Neighbour&) = delete;
  Neighbour& operator=(const Neighbour&) = delete;

  /// Stores the end of its simulation.
  void end_with(const End<double>& end, std::exception_ptr thrown);
};

/// Passes one simulation to its observer, and the others to their neighbours' traces.
template <class SomeObserver>
class ShownTo : public Observer {
 public:
  explicit ShownTo(SomeObserver* given) : given_(given) {}
  explicit ShownTo(FeatureTrace* trace) requires(!std::is_same_v<SomeObserver, FeatureTrace>)
      : trace_(trace) {}

  bool hears_stretches() const {
    return given_ != nullptr ? given_->hears_stretches() : trace_->hears_stretches();
  }
  void impact(double time, Wall wall, double speed) {
    tell([&](auto& observer) { observer.impact(time, wall, speed); });
  }
  void peak(double time, double position) {
    tell([&](auto& observer) { observer.peak(time, position); });
  }
  void turn(double time, double position, Wall ahead) {
    tell([&](auto& observer) { observer.turn(time, position, ahead); });
  }
  void hops(double time, Wall wall) {
    tell([&](auto& observer) { observer.hops(time, wall); });
  }
  template <class Path>
  void stretch(double time, const Path& path, double duration) {
    tell([&](auto& observer) { observer.stretch(time, path, duration); });
  }

 private:
  template <class Call>
  [[gnu::always_inline]] void tell(const Call& call) {
    if (given_ != nullptr) {
      call(*given_);
    } else {
      call(*trace_);
    }
  }

  SomeObserver* given_ = nullptr;
  FeatureTrace* trace_ = nullptr;
};

/// The four neighbours of a valid scene: all constants changed at once in their tenth digit, in two
/// patterns and their opposites. One of each pattern is one side; often it is enough.
class Neighbours {
 public:
  using Side = std::array<const Neighbour*, 2>;

  explicit Neighbours(const Scene& scene);

  /// Simulates the scene itself for an observer and, where all of them fit into lanes, one side of
  /// its neighbours with it. Throws what the simulation of the scene throws.
  template <class SomeObserver>
  End<double> simulate_with(const Scene& scene, SomeObserver& observer) {
    if (!fits_lanes(scene)) return simulate(scene, observer);
    std::vector<ShownTo<SomeObserver>> observers = {ShownTo<SomeObserver>(&observer)};
    const std::vector<Neighbour*> sound = sound_ones(0);
    for (Neighbour* n : sound) observers.emplace_back(&n->trace);
    const auto outcomes = run_in_lanes(
        observers.size(),
        [&](std::size_t k) { return ImpactModel<double>(k == 0 ? scene : sound[k - 1]->scene); },
        [&](std::size_t k) -> ShownTo<SomeObserver>& { return observers[k]; });
    if (outcomes.front().failure) std::rethrow_exception(outcomes.front().failure);
    for (std::size_t k = 0; k < sound.size(); ++k) {
      sound[k]->end_with(outcomes[k + 1].end, outcomes[k + 1].failure);
    }
    simulated_[0] = true;
    return outcomes.front().end;
  }

  /// One side, simulated.
  Side one_side();

  /// All neighbours, simulated, a pattern and its opposite after one another. After one whose
  /// simulation fails, the others may not be simulated.
  const std::array<Neighbour, 4>& all();

 private:
  /// Simulates the neighbours of a side, 0 or 1, once.
  void simulate_side(std::size_t side);

  /// Returns the neighbours of a side whose walls do not cross; stores a failure for the others.
  std::vector<Neighbour*> sound_ones(std::size_t side);

  std::array<Neighbour, 4> all_;
  std::array<bool, 2> simulated_{};
};

}  // namespace ricochet::carrier_track::inline counting
