#pragma once

#include "src/campaign/campaign.h"

namespace ricochet::studies {

/// All questions and solvers of the suite, solvers of the user's own, and grids of machines around
/// the paper's cases.
Catalogue whole_catalogue();

}  // namespace ricochet::studies
