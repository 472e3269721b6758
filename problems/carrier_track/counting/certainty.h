#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "problems/carrier_track/motion/impact_model.h"
#include "problems/carrier_track/motion/observer.h"
#include "problems/carrier_track/motion/simulate.h"
#include "problems/carrier_track/scene/scene_values.h"
#include "ricochet/machine.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline counting {

/// Records of a simulation, for comparison with that of a slightly different scene: its features
/// (count.h), impacts and nearest graze.
class FeatureTrace : public Observer {
 public:
  struct Feature {
    double time;  ///< [s], when it is known to count
    /// z if the feature counts, else exp(z) - 1 (under the rule of impacts minus the missing share
    /// of the speed), which changes little for features that are far from counting.
    double scaled;

    bool counts() const { return scaled > 0; }
    double margin() const { return counts() ? scaled : std::log1p(scaled); }  ///< z
  };
  enum Kind : std::size_t { lower_impact, upper_impact, high_peak, low_peak, kinds };

  /// `scene` must outlive the trace.
  explicit FeatureTrace(const Scene& scene) : scene_(scene) {
    for (std::vector<double>& times : impacts_) times.reserve(usual_impacts);
    if (scene.rule != CountRule::impacts) return;
    for (const Kind kind : {lower_impact, upper_impact}) features_[kind].reserve(usual_impacts);
  }

  void impact(double time, Wall wall, double speed);
  void peak(double time, double position);
  void turn(double time, double position, Wall ahead);
  void hops(double time, Wall wall);
  void contact(double time, double position, double velocity);

  /// True if maxima count. Under the rule of impacts, impacts and turning points suffice.
  bool hears_stretches() const { return scene_.rule == CountRule::peaks; }

  template <class Path>
  void stretch(double time, const Path& path, double duration) {
    finite_ = finite_ && std::isfinite(path.position + path.velocity + time + duration);
    swung_out_ = false;
    if (std::exchange(counting_peak_, false)) {
      const double drop = path.position - path.at(duration).position;
      if (drop <= perturbation_size * (path.position - scene_.wall_lower)) shallow_ = time;
    }
    now_ = time + duration;
  }

  /// The features of a Kind, in order of time.
  const std::vector<Feature>& features(std::size_t kind) const { return features_[kind]; }
  const std::vector<double>& impacts(Wall wall) const {
    return impacts_[wall == Wall::lower ? lower_impact : upper_impact];
  }
  const std::optional<Graze>& graze() const { return graze_; }

  /// Infinitely many maxima that count: of ever smaller rebounds on a wall, or of ever smaller
  /// oscillations in a compliant wall. A simulation reports only some of them.
  struct Endless {
    double time;  ///< [s]
    Wall wall;
  };
  const std::optional<Endless>& endless() const { return endless_; }

  /// Time [s] of a maximum off the walls that counts and from which the body fell by less than the
  /// tenth digit of its height. Rounding makes such a maximum if the speed only touches zero.
  const std::optional<double>& shallow_peak() const { return shallow_; }

  /// The largest finite coordinate [m] of walls and start.
  double reach() const;

  /// Returns true if all reported values are finite; they are not if numbers overflow.
  bool finite() const { return finite_; }

 private:
  static constexpr std::size_t usual_impacts = 64;  // on one wall

  void tell(std::size_t kind, double scaled);

  const Scene& scene_;
  std::array<std::vector<Feature>, kinds> features_;
  std::array<std::vector<double>, 2> impacts_;  // times [s]
  std::optional<Graze> graze_;
  double now_ = 0;  // [s]
  std::optional<Endless> endless_;
  std::optional<double> shallow_;
  bool counting_peak_ = false;  // true while the body falls from a maximum that counts
  bool finite_ = true;
  bool swung_out_ = false;  // true if the body has moved outwards in its present contact
};

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

// Tests whether a count is certain. A scene's constants are known to a few digits only, and a
// simulation rounds. So the scene is simulated again with all constants changed at once in their
// tenth digit (perturbation.h), and the features of the motion (count.h) are compared one by
// one. A count is certain if such a change makes no feature start or stop to count. A count is not
// certain if infinitely many maxima count, if the change makes the walls cross, or if numbers
// overflow.

/// Returns the certainty of the count of a valid scene from its `trace` and `neighbours`. Simulates
/// the neighbours if they are needed and not simulated yet.
Certainty certainty_of(const Scene& scene, const FeatureTrace& trace, Neighbours& neighbours);

/// A feature of which it is in doubt whether it counts.
struct Suspect {
  double time = std::numeric_limits<double>::infinity();  ///< [s]
  std::size_t kind = 0;                                   ///< a FeatureTrace::Kind
  double margin = 0;
  Doubt doubt = Doubt::none;
  double left = 0;  ///< [s], time to the end of the window
};

/// A feature that occurs in both traces.
struct FeaturePair {
  double time;    ///< [s], in the given trace
  double change;  ///< absolute difference of the scaled margins
};

/// Compares the features of a simulation with those of a slightly different scene, one by one.
class FeatureComparison {
 public:
  /// The ends [s] are those of the scenes' windows.
  FeatureComparison(const FeatureTrace& given, double given_end, const FeatureTrace& other,
                    double other_end);

  /// The first feature in doubt; Doubt::none if there is none.
  const Suspect& first() const { return first_; }
  const std::vector<FeaturePair>& pairs() const { return pairs_; }

  /// Returns true if everything is further from starting or stopping to count than
  /// `clear_factor` times the largest change of anything: then the opposite of the small difference
  /// cannot raise a doubt either, since to first order it changes everything by the opposite.
  bool is_clear() const { return is_clear_; }

  static constexpr double clear_factor = 100;

 private:
  using List = std::vector<FeatureTrace::Feature>;

  void compare(std::size_t kind, const List& given, double given_end, const List& others,
               double other_end);
  void find_near_end(std::size_t kind, const List& features, double end);
  void suspect(std::size_t kind, const FeatureTrace::Feature& f, Doubt doubt, double end);
  bool is_clear(const FeatureTrace& given, const FeatureTrace& other) const;

  Suspect first_;
  std::vector<FeaturePair> pairs_;
  double moved_ = 0;    // largest movement of a feature in time, as a share of the window
  double changed_ = 0;  // largest change of a pair
  double nearest_ = 1;  // smallest |scaled margin| of a given feature
  bool is_clear_ = false;
};

}  // namespace ricochet::carrier_track::inline counting
