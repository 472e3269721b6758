#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "src/benchmark/analysis/outcomes.h"
#include "src/benchmark/analysis/targets.h"
#include "src/benchmark/experiment/campaign/campaign.h"

namespace ricochet::comparison {

/// The outcomes of the runs of one cell, sorted by instance, then run: one solver-formulation pair
/// on one problem with one budget.
struct CellResult {
  const PlannedCell* cell;
  Outcomes outcomes;
  std::shared_ptr<const Targets> targets;  ///< of the problem
};

/// The results of every cell of a campaign, which must outlive them. Each run of the store is read
/// once and also passed to `also`, as in Store::each. Throws InputError if the store lacks runs.
std::vector<CellResult> cell_results(
    const Campaign& campaign, const Store& store,
    const std::function<void(const StoredRun&)>& also = [](const StoredRun&) {});

/// The largest budget of any cell, by problem (an index of the campaign's).
std::map<std::size_t, std::int64_t> largest_budgets(const std::vector<CellResult>& results);

}  // namespace ricochet::comparison
