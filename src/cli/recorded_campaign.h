#pragma once

#include "src/benchmark/experiment/campaign/campaign.h"
#include "src/benchmark/experiment/store/store.h"

namespace ricochet::cli {

/// The campaign of a store, for reading its runs. The user's solvers are in it as recorded, or as
/// their runs show them: they cannot solve, and no program is started. Leaves out other solvers
/// that this build lacks.
Campaign recorded_campaign(const Store& store);

}  // namespace ricochet::cli
