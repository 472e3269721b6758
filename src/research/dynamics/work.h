#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/reference_integrators/accuracy.h"
#include "problems/carrier_track/reference_integrators/integrator.h"
#include "src/report/json.h"

/// Work against precision: what the accuracy of a method costs.
namespace ricochet::studies::dynamics {

/// A scene that methods are put to.
struct BenchmarkScene {
  std::string id;           ///< part of charts' names
  std::string name;         ///< as a heading
  std::string description;  ///< a sentence or two
  carrier_track::Scene scene;
  bool chaotic = false;  ///< impacts cannot be matched for long: only their rate is compared
};

/// Mild, fast, sticking, grazing and chaotic; the chaotic one with `seconds` [s] of window.
std::vector<BenchmarkScene> benchmark_scenes(double seconds);

/// The one of these with that id. Throws std::invalid_argument if there is none.
carrier_track::Scene benchmark_scene(const std::string& id, double seconds);

/// A shaken gap with walls of `stiffness` [N/m^1.5] that return 0.9, by exact-restitution with
/// every impact's own speed; seven impacts or so.
carrier_track::Scene stiff_gap(double stiffness);

/// The mild scene on compliant walls, stiff and very stiff, for penalty_integrators.
std::vector<BenchmarkScene> stiff_benchmark_scenes();

/// One run of a method.
struct Trial {
  double control;
  double seconds;  ///< [s] of processor time a run
  std::int64_t force_evaluations;
  bool finished;
  carrier_track::Accuracy accuracy;  ///< of a finished run
  /// [s] of impact times, or in a chaotic scene the relative distance from the mean rate;
  /// nothing where the run failed: not finished, impacts missed or spurious, or none to compare.
  std::optional<double> error;
};

struct MethodWork {
  std::string method;
  std::string control;        ///< what the control means; "none": only one trial
  std::vector<Trial> trials;  ///< from the loosest control to the tightest
};

struct SceneWork {
  BenchmarkScene benchmark;
  int impacts = 0;  ///< those of the reference that count, at least 1
  /// Chaotic alone, of 32 references whose start velocity differs by parts in 1e12: the mean of
  /// their impacts, and three relative standard deviations. No method can be held to more.
  double mean_impacts = 0;
  double rate_spread = 0;
  std::vector<MethodWork> methods;  ///< the event-driven reference first
};

/// How far the controls go: `per_decade` of each, tolerances from 1e-3 to `tolerance`, steps from a
/// tenth of the mean time between impacts to this over `steps`.
struct WorkPlan {
  int per_decade;
  double tolerance;
  double steps;
};

/// Runs every method over its controls, one after the other on this thread, and measures the
/// processor time: of three measurements the least, each of as many runs as take half a
/// millisecond; of runs longer than 30 ms only one. Calls `done` after every method.
SceneWork work_in(
    const BenchmarkScene& benchmark, const WorkPlan& plan,
    const std::vector<carrier_track::Integrator>& integrators,
    const std::function<void()>& done = [] {});

/// The loosest trial from which on every error is at most `limit`; nothing if the tightest is not.
std::optional<Trial> loosest_within(const MethodWork& method, double limit);

/// What the methods' accuracy costs in one scene.
report::Json data_of(const SceneWork& work);

/// The time and the evaluations of every method over those of the event-driven one, in all scenes.
report::Json speed_data(const std::vector<SceneWork>& works);

}  // namespace ricochet::studies::dynamics
