#pragma once

#include "src/experiment/campaign.h"
#include "src/report/json.h"
#include "src/report/site/study.h"

namespace ricochet::studies {

/// Evaluates a campaign whose runs are complete: which entry solves what, in which formulation,
/// with which significance and cost; effects of perturbations, prices and machines; robustness of
/// the ranking to instances, seeds, budgets and machines. It reads the store and starts no run.
/// Both must outlive it.
Study comparison_study(const Campaign& campaign, const Store& store);

}  // namespace ricochet::studies
