#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/analysis/results.h"
#include "src/experiment/campaign.h"
#include "src/experiment/planned_runs.h"
#include "src/experiment/store.h"
#include "src/experiment/stored_campaign.h"
#include "src/report/json.h"

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

/// Seconds as text in a suitable unit.
std::string duration(double seconds);

/// Counts what a campaign runs.
report::Json size_of(const Campaign& campaign);

/// The same as text.
std::string in_words(const report::Json& size);

/// A forecast as text: the elapsed time on so many cores.
std::string in_words(const Forecast& forecast, int cores);

/// A campaign with complete runs, scored.
struct FinishedCampaign {
  Campaign campaign;
  std::vector<comparison::CellResult> results;
};

/// Reads a store, see recorded_campaign().
FinishedCampaign finished_campaign(const Store& store);

/// The campaign of a store, for reading its runs. The user's solvers are in it as recorded, or as
/// their runs show them: they cannot solve, and no program is started. Leaves out other solvers
/// that this build lacks.
Campaign recorded_campaign(const Store& store);

}  // namespace ricochet::cli
