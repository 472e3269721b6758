#pragma once

#include <string>

#include "ricochet/run.h"

namespace ricochet {

/// Says of a record what no run can have: "charged is 61: must be from 0 to 60, the evaluations
/// allowed". Empty if there is nothing. It knows neither problem nor plan. Holds for thinned
/// records too, in whose traces times are left out and objectives are rounded to floats.
std::string impossibility(const RunRecord& record);

/// The most starts of a solver in one run.
constexpr std::int64_t most_starts = 10'000'000;

}  // namespace ricochet
