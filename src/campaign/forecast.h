#pragma once

#include "src/campaign/campaign.h"

namespace ricochet {

/// Processor time [s] that a campaign's runs will take, about: by the time that an evaluation of
/// every question takes at its start, and by what every solver adds to an evaluation in its
/// shortest run, which is made for this. Less than the truth where solvers grow slower with the
/// number of variables or of evaluations; more where runs end before their budget is spent.
double foretold_seconds(const Campaign& campaign);

}  // namespace ricochet
