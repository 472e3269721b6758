#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/recording.h"
#include "ricochet/recording.h"
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

}  // namespace ricochet::carrier_track::inline reference_integrators
