#pragma once

#include <string>
#include <vector>

#include "src/benchmark/analysis/cell_results.h"

namespace ricochet::cli {

/// A campaign with complete runs, scored.
struct FinishedCampaign {
  Campaign campaign;
  std::vector<comparison::CellResult> results;
};

/// Reads a store or an archive, for instance "archive"; leaves out solvers that this build lacks.
FinishedCampaign finished_campaign(const std::string& store);

}  // namespace ricochet::cli
