#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/check/flight_method.h"
#include "problems/carrier_track/counting/recording.h"
#include "ricochet/machine.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline reference_integrators {

/// The result of a numerical method for a scene.
struct Outcome {
  std::vector<Impact> impacts;         ///< all detected impacts, slow ones too
  Sample end{};                        ///< where it ended; the end of the window if finished
  std::int64_t force_evaluations = 0;  ///< event-driven: of the closed-form flight
  bool finished = false;
  std::string failure;  ///< why it did not finish, e.g. too many steps

  // For penalty methods only, which enter the walls.
  double deepest = 0;  ///< [m] behind a wall; infinite: more than the gap, which ended the run
  /// [m/s]; the largest excess of the speed after a contact over that before it and the possible
  /// increase by the applied forces in between. No wall gives energy: > 0 is the method's error.
  /// Empty if no contact has ended.
  std::optional<double> gained;
};

/// A method for the whole hybrid motion: flights, impacts, sticking and the ends of Zeno sequences.
/// `run` takes a valid scene and a control parameter > 0. It never throws, and it always ends: a
/// run with too many steps or impacts is not finished. Runs share no state.
struct Integrator {
  std::string name;
  std::string version;
  std::string control;  ///< meaning and unit of the number given to `run`
  std::function<Outcome(const Scene&, double control)> run;
};

/// The project's own event-driven simulator first, then the methods compared with it.
std::vector<Integrator> all_integrators();

/// The same event-driven simulator first, then methods that integrate straight through the contacts
/// of compliant walls. They refuse scenes with hard walls or with friction.
std::vector<Integrator> penalty_integrators();

/// Names of the integrators missing from this build, which has no SUNDIALS.
std::vector<std::string> missing_integrators();

/// A rebound slower than this [m/s] against a pressing force ends a Zeno sequence for every method
/// here except the event-driven one, which sums it in closed form (resting_speed). Under the forces
/// of these scenes it rises 1e-12 m, about the rounding of a position in a track.
inline constexpr double slowest_rebound = 1e-6;

/// A run with more impacts than this is not finished.
inline constexpr std::size_t most_impacts = 1'000'000;

// One method per source file; integrator.cpp lists them.

/// ImpactModel: flights in closed form, events by conservative advancement. For compliant walls the
/// CompliantModel at its tightest tolerance, 1e-12. Ignores the control parameter.
Integrator event_driven();

/// Boost.Odeint's Dormand-Prince 5(4), events on its dense output.
Integrator odeint_dopri5();

/// Boost.Odeint's Rosenbrock method of order 4, events on its dense output.
Integrator odeint_rosenbrock4();

/// SUNDIALS CVODE, Adams-Moulton of order 1 to 12, with its own rootfinding.
Integrator cvode_adams();

/// SUNDIALS CVODE, backward differentiation of order 1 to 5, with its own rootfinding.
Integrator cvode_bdf();

/// Fixed steps; walls are detected at the end of a step.
Integrator semi_implicit_euler();
Integrator runge_kutta_4();

/// Moreau-Jean time-stepping, theta = 1/2: contact and friction as impulses at velocity level.
Integrator moreau_jean();

/// Penalty methods (penalty.h): integrate straight through the contacts of compliant walls. CVODE
/// iterates Adams-Moulton by fixed point, as for non-stiff motion, and BDF by Newton.
Integrator penalty_semi_implicit_euler();
Integrator penalty_runge_kutta_4();
Integrator penalty_odeint_dopri5();
Integrator penalty_odeint_rosenbrock4();
Integrator penalty_cvode_adams();
Integrator penalty_cvode_bdf();

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
Accuracy compare(const Scene& scene, const Outcome& outcome, const Outcome& reference);

/// The number of impacts of `outcome` above the scene's `counting_limit`.
int collisions(const Scene& scene, const Outcome& outcome);

/// Simulates a valid scene with the flights of `method`, made for the same scene. The discrete part
/// of the motion is the same for all such methods:
/// - Impact: the velocity is reversed and multiplied by the restitution, and the method restarted.
/// - Rest: on a wall, unless the force leads away, once the rebound is at most slowest_rebound or
///   its height is lost in the rounding of the position; in the gap if the velocity is zero and
///   friction holds the body.
/// - Departure: when the applied force exceeds what friction and wall hold, detected by a sign
///   change between samples 1/64 of the shortest period apart and located to rounding. An excess
///   that lasts less than that is missed.
Outcome run_with_located_events(const Scene& scene, FlightMethod& method);

}  // namespace ricochet::carrier_track::inline reference_integrators
