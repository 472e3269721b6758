#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/benchmark/experiment/campaign/planned_runs.h"
#include "src/benchmark/experiment/campaign/stored_campaign.h"

namespace ricochet::cli {

struct RunOptions {
  std::string plan;                      ///< TOML file, or the name of a plan that is included
  std::string out = "reports/campaign";  ///< folder of the store, runs.sqlite
  std::string shard = "1/1";
  bool resume = false;
  std::vector<std::string> from;  ///< stores, archives: their runs that are the plan's are kept
  bool allow_programs = false;    ///< that the plan names
  int jobs = 0;                   ///< runs at once; 0: one for every core, or one under MPI
  std::string serve;  ///< under MPI, the role of this process: "store" or "runs"; see service.h
};

/// Makes the runs that are missing in the folder's store, or has the other ranks make them. If that
/// is interrupted, `continuation` is what goes on.
StoredCampaign carried_out(const Plan& plan, const Catalogue& catalogue, const Shard& shard,
                           const RunOptions& options, std::string_view continuation);

}  // namespace ricochet::cli
