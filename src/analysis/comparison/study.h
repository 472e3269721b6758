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

namespace ricochet::studies::comparison {

/// Splits all results into the data of a comparison's report: the page with the answers, and under
/// `pages` one for each family, one across machines and one of failures, if there are any.
report::Json in_pages(report::Json all);

}  // namespace ricochet::studies::comparison
