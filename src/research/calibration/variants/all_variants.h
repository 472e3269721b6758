#pragma once

#include <cstdint>
#include <vector>

#include "src/research/calibration/variants/model_variant.h"
#include "src/research/calibration/variants/ode45.h"

namespace ricochet::studies::variants {

/// The unchanged references of the variants: projected centrifugal force, constant tension and a
/// number of turns, with friction on the walls' normal force, and without; and the former again
/// with as few evaluations as the expensive variants. Counts are those of the event-driven model.
std::vector<ModelVariant> baselines();

/// All variants.
std::vector<ModelVariant> all_variants();

/// The disturbance is a random number, held for an interval that is a parameter, instead of a
/// cosine; `draw` is the seed of the numbers.
ModelVariant random_disturbance(const carrier_track::Interpretation& base, std::uint64_t draw);

/// Compliant walls, integrated without event location as in stepped_walls.h.
ModelVariant stepped_walls(const std::string& name, const OdeTolerances& tolerances);

/// Tolerances that show the remaining part of the default's error.
inline constexpr OdeTolerances tight_tolerances = {1e-6, 1e-9};

/// The parameters of a variant of stepped walls, with exact events instead of steps.
carrier_track::CountAt exact_walls(const carrier_track::Case& a_case,
                                   const VariantConstants& constants);

}  // namespace ricochet::studies::variants
