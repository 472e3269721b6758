#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "ricochet/machine.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline reference_integrators {

/// The result of a numerical method for a scene.
struct Outcome {
  std::vector<Impact> impacts;         ///< all detected impacts, slow ones too
  Sample end{};                        ///< where it ended; the end of the window if finished
  std::int64_t force_evaluations = 0;  ///< of the applied forces, or of the closed-form flight
  double seconds = 0;                  ///< [s], processor time
  bool finished = false;
  std::string failure;  ///< why it did not finish, e.g. too many steps

  // For motion through compliant walls only.
  double deepest = 0;  ///< [m] behind a wall; infinite: more than the gap, which ended the run
  /// [m/s]; the largest excess of the speed after a contact over that before it and the possible
  /// increase by the applied forces in between. No wall gives energy: > 0 is the method's error.
  /// Empty if no contact has ended.
  std::optional<double> gained;
};

/// A method for the whole motion in one direction: flights, impacts, sticking and the ends of Zeno
/// sequences, or straight through the contacts of compliant walls, for a scene of that fidelity.
struct Integrator {
  std::string name;
  std::string version;  ///< of the library
  std::string title;
  std::string kind;              ///< "closed form", "event location", "time stepping" or "penalty"
  std::string setting;           ///< meaning and unit of the number given to `run`
  std::array<double, 3> levels;  ///< loose, usual and tight settings
  bool takes_compliant = true;   ///< walls; hard ones are taken by all
  /// `scene` is valid, `setting` > 0. It never throws, and it always ends: a run with too many
  /// steps or impacts is not finished. Runs share no state.
  std::function<Outcome(const Scene& scene, double setting)> run;
};

// The kinds of settings.
inline constexpr const char* no_setting = "none";
inline constexpr const char* by_tolerance = "relative tolerance";
inline constexpr const char* by_step = "step [s]";
inline constexpr const char* by_depth = "depth in a wall / clearance";

/// The project's own event-driven simulator first, then the methods compared with it:
/// - Dormand-Prince 5(4) and Rosenbrock of order 4 of Boost.Odeint, events on the dense output;
///   Adams and BDF of SUNDIALS CVODE, with its own rootfinding;
/// - semi-implicit Euler and Runge-Kutta of order 4 with fixed steps, where a wall is detected at
///   the end of a step; Moreau-Jean's time stepping;
/// - `penalty`, which makes stiff springs and dampers of hard walls, and smooths friction.
/// Through the contacts of compliant walls they integrate as if there were no events, which needs a
/// scene without friction.
std::vector<Integrator> all_integrators();

/// The names of those that this build lacks, because it was made without SUNDIALS.
std::vector<std::string> methods_not_built();

/// A rebound slower than this [m/s] against a pressing force ends a Zeno sequence for every method
/// here except the event-driven one, which sums it in closed form (resting_speed). Under the forces
/// of these scenes it rises 1e-12 m, about the rounding of a position in a track.
inline constexpr double slowest_rebound = 1e-6;

/// A run with more impacts than this is not finished.
inline constexpr std::size_t most_impacts = 1'000'000;

/// The number of impacts of `outcome` above the scene's `counting_limit`.
int collisions(const Scene& scene, const Outcome& outcome);

}  // namespace ricochet::carrier_track::inline reference_integrators
