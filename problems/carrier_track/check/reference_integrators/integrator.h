#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/scene/scene.h"

namespace ricochet::carrier_track::inline reference_integrators {

/// What a numerical method makes of a scene.
struct Outcome {
  std::vector<Impact> impacts;         ///< every one that the method saw, slow ones too
  Sample end{};                        ///< where it ended; the end of the window if finished
  std::int64_t force_evaluations = 0;  ///< event-driven: of the closed-form flight
  bool finished = false;
  std::string failure;  ///< why it did not finish, for instance too many steps

  // Of penalty methods alone, which see the inside of the walls.
  double deepest = 0;  ///< [m] behind a wall; infinite: more than the gap, which ended the run
  /// [m/s]; the largest excess of the speed out of a wall again over that before it and what the
  /// applied forces can have added in between. No wall gives energy: > 0 is the method's error.
  /// Nothing where no contact has ended.
  std::optional<double> gained;
};

/// A method for the whole hybrid motion: flights, impacts, sticking and the ends of Zeno sequences.
/// `run` takes a valid scene and a control > 0. It never throws, and it always ends: a run with
/// too many steps or impacts is not finished. Runs share nothing.
struct Integrator {
  std::string name;
  std::string version;
  std::string control;  ///< what the number given to `run` means, with its unit
  std::function<Outcome(const Scene&, double control)> run;
};

/// The project's own event-driven simulator first, then what it is compared with.
std::vector<Integrator> all_integrators();

/// The same event-driven simulator first, then methods that integrate straight through the contacts
/// of compliant walls. They refuse scenes with hard walls, and with friction.
std::vector<Integrator> penalty_integrators();

/// Names of those that this build lacks, for it has no SUNDIALS.
std::vector<std::string> missing_integrators();

/// A rebound slower than this [m/s] against a pressing force ends a Zeno sequence for every method
/// here but the event-driven one, which sums it in closed form (resting_speed). Its hop under the
/// forces of these scenes is 1e-12 m high, about the rounding of a position in a track.
inline constexpr double slowest_rebound = 1e-6;

/// A run with more impacts than this is not finished.
inline constexpr std::size_t most_impacts = 1'000'000;

}  // namespace ricochet::carrier_track::inline reference_integrators
