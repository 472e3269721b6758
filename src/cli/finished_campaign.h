#pragma once

#include <vector>

#include "src/benchmark/analysis/cell_results.h"
#include "src/benchmark/experiment/store/store.h"

namespace ricochet::cli {

/// A campaign with complete runs, scored.
struct FinishedCampaign {
  Campaign campaign;
  std::vector<comparison::CellResult> results;
};

/// Reads a store, see recorded_campaign().
FinishedCampaign finished_campaign(const Store& store);

}  // namespace ricochet::cli
