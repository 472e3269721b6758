#pragma once

#include <cstdint>
#include <vector>

#include "src/studies/trials/ode45.h"
#include "src/studies/trials/trial.h"

namespace ricochet::studies::trials {

/// What the trials change, with nothing changed: the projected centrifugal force, constant tension
/// and a number of turns, with friction on the walls' own force, and without; and the former once
/// more, searched as briefly as the dear trials. Counts are those of the event-driven model.
std::vector<Trial> baselines();

/// All that is tried.
std::vector<Trial> all_trials();

/// The disturbance a random number, held for a constant of its own, instead of a cosine; `draw`
/// is the seed of the numbers.
Trial random_disturbance(const carrier_track::Reading& base, std::uint64_t draw);

/// Compliant walls, integrated straight through as stepped_walls.h says.
Trial stepped_walls(const std::string& name, const OdeTolerances& tolerances);

/// The tolerances that show what is left of the default's error.
inline constexpr OdeTolerances tight_tolerances = {1e-6, 1e-9};

/// The constants of a trial of stepped walls, with exact events in place of steps.
carrier_track::CountAt exact_walls(const carrier_track::Case& a_case,
                                   const TrialConstants& constants);

}  // namespace ricochet::studies::trials
