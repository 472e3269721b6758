#pragma once

#include "src/experiment/campaign.h"

namespace ricochet::studies {

/// All problems and solvers of the suite, the user's solvers, and grids of machines around the
/// paper's cases.
Catalogue whole_catalogue();

}  // namespace ricochet::studies
