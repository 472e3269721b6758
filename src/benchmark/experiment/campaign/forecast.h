#pragma once

#include "src/benchmark/experiment/campaign/campaign.h"

namespace ricochet {

/// Estimated processor time [s] of a campaign's runs, from the time of an evaluation of every
/// problem at its start, and from the time that every solver adds to an evaluation in its shortest
/// run, which is made for this purpose. Too low if solvers become slower with the number of
/// variables or evaluations; too high if runs end before their budget is spent.
double foretold_seconds(const Campaign& campaign);

}  // namespace ricochet
