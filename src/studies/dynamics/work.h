#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/check/integrator.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "src/report/results.h"

/// Work-precision diagrams: the cost of a method's accuracy.
namespace ricochet::studies::dynamics {

/// A scene for benchmarks of methods.
struct BenchmarkScene {
  std::string id;           ///< part of charts' names
  std::string name;         ///< as a heading
  std::string description;  ///< a sentence or two
  carrier_track::Scene scene;
  bool chaotic = false;  ///< impacts cannot be matched for long: only their rate is compared
};

/// Mild, fast, sticking, grazing and chaotic; the chaotic one with a window of `seconds` [s].
std::vector<BenchmarkScene> benchmark_scenes(double seconds);

/// Returns the scene with that id. Throws std::invalid_argument if there is none.
carrier_track::Scene benchmark_scene(const std::string& id, double seconds);

/// A shaken gap with walls of `stiffness` [N/m^1.5] that return 0.9, by exact-restitution with
/// every impact's own speed; about seven impacts.
carrier_track::Scene stiff_gap(double stiffness);

/// The errors of an outcome relative to a reference for the same scene.
///
/// An impact is fast if the scene counts it: its speed is above `counting_limit`. Fast impacts are
/// matched in order: the next two of both lists are partners if they are on the same wall and no
/// further apart than half the mean time between the reference's fast impacts; otherwise the
/// earlier one has no partner. A partner needs only half that speed, so that an impact just above
/// the limit still has one that is slightly slower.
struct Accuracy {
  int missed = 0;    ///< fast impacts of the reference without a partner
  int spurious = 0;  ///< fast impacts of the outcome without a partner
  int matched = 0;   ///< pairs before the paths diverge, at the first impact counted above
  /// Largest difference of the times of those pairs [s]; empty without a pair.
  std::optional<double> impact_time_error;
  int count_difference = 0;       ///< fast impacts of the outcome minus those of the reference
  double end_position_error = 0;  ///< [m], at the end of the window
};

/// `outcome` and `reference` are finished runs of the valid `scene`. The rule `impacts` is applied
/// whatever the scene's rule: outcomes contain no peaks.
Accuracy compare(const carrier_track::Scene& scene, const carrier_track::Outcome& outcome,
                 const carrier_track::Outcome& reference);

/// The integrators of hard walls, and those that go through the contacts of compliant walls.
std::vector<carrier_track::Integrator> between_hard_walls();
std::vector<carrier_track::Integrator> through_walls();

/// The mild scene on compliant walls, stiff and very stiff, for through_walls().
std::vector<BenchmarkScene> stiff_benchmark_scenes();

/// One run of a method.
struct Trial {
  double control;
  double seconds;  ///< [s] of processor time per run
  std::int64_t force_evaluations;
  bool finished;
  Accuracy accuracy;  ///< of a finished run
  /// [s] of impact times, or in a chaotic scene the relative error of the mean rate; nothing if the
  /// run failed: not finished, impacts missed or spurious, or none to compare.
  std::optional<double> error;
};

struct MethodWork {
  std::string method;
  std::string control;        ///< meaning of the control; "none": only one trial
  std::vector<Trial> trials;  ///< from the loosest control to the tightest
};

struct SceneWork {
  BenchmarkScene benchmark;
  int impacts = 0;  ///< counted impacts of the reference, at least 1
  /// Only for chaotic scenes, from 32 references whose start velocities differ by parts in 1e12:
  /// the mean number of impacts, and three relative standard deviations, a limit for every method.
  double mean_impacts = 0;
  double rate_spread = 0;
  std::vector<MethodWork> methods;  ///< the event-driven reference first
};

/// Range of the controls: `per_decade` of each, tolerances from 1e-3 to `tolerance`, steps from a
/// tenth of the mean time between impacts to this over `steps`.
struct WorkPlan {
  int per_decade;
  double tolerance;
  double steps;
};

/// Runs every method over its controls, one after the other on this thread, and measures the
/// processor time: the minimum of three measurements, each of as many runs as take half a
/// millisecond; of runs longer than 30 ms only one. Calls `done` after every method.
SceneWork work_in(
    const BenchmarkScene& benchmark, const WorkPlan& plan,
    const std::vector<carrier_track::Integrator>& integrators,
    const std::function<void()>& done = [] {});

/// Returns the loosest trial from which on every error is at most `limit`; nothing if the tightest
/// is not.
std::optional<Trial> loosest_within(const MethodWork& method, double limit);

/// Adds the cost of the methods' accuracy relative to the event-driven one: all scenes, of which
/// the first has every method, in tables, and each as a part with its chart.
void add_to(report::Results& results, const std::vector<SceneWork>& works);

// Restitution that a contact law returns, compared with the value its damping was computed from.

struct ReturnedRestitution {
  double asked;     ///< in (0, 1)
  double returned;  ///< in [0, 1]
};

/// One law, by its closed relation and by simulation.
struct LawStudy {
  std::string name;  ///< as in a scene's file
  carrier_track::ContactLaw law;
  std::vector<ReturnedRestitution> exact;     ///< finely spaced
  std::vector<ReturnedRestitution> measured;  ///< of simulated impacts
};

/// The requested value with the largest difference from the returned one, by the closed relation.
ReturnedRestitution worst_of(const LawStudy& study);

/// Largest difference between a measured point and the closed relation at it.
double largest_measurement_error(const LawStudy& study);

/// Returned restitution by the closed relation (returned_restitution, kelvin_voigt_restitution),
/// for asked in (0, 1).
double closed_return(carrier_track::ContactLaw law, double asked);

/// Ratio of the speeds after and before a simulated impact on a compliant wall, at 1 m/s, without
/// any other force.
double measured_return(carrier_track::ContactLaw law, double asked);

/// Every law, for 0.02, 0.03, ..., 0.98, and by simulation for every `stride`-th of them.
std::vector<LawStudy> study_laws(std::size_t stride);

/// Adds requested against returned restitution, a line for each law.
void add_to(report::Results& results, const std::vector<LawStudy>& laws);

}  // namespace ricochet::studies::dynamics
