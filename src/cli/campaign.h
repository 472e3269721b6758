#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/benchmark/comparison/comparison_plan.h"
#include "src/benchmark/experiment/campaign/stored_campaign.h"
#include "src/cli/scene_choice.h"

namespace ricochet::cli {

struct RunOptions {
  std::string plan = "default";          ///< TOML file, or the name of a plan that is included
  std::string out = "reports/campaign";  ///< folder of the store, runs.sqlite
  std::string shard = "1/1";
  bool resume = false;
  std::vector<std::string> from;  ///< stores, archives: their runs that are the plan's are kept
  bool allow_programs = false;    ///< that the plan names
  int jobs = 0;                   ///< runs at once; 0: one for every core, or one under MPI
  std::string serve;  ///< under MPI, the role of this process: "store" or "runs"; see service.h
};

/// Runs or resumes a plan; it is one of the ranks if mpirun started several. After all runs it
/// writes the report.
int run_plan(const RunOptions& options);

/// Compares solvers on problems as a separate campaign, which resumes automatically if it was
/// interrupted. With a scene file, on the problems of its machine.
int compare(studies::ComparisonOptions options, const SceneChoice& scene, bool quick,
            const std::string& out);

/// Compares the user's solvers with those whose runs an archive has. Resumes as compare() does.
int compare_against(const std::string& archive, const std::vector<std::string>& own_solvers,
                    const std::string& out);

}  // namespace ricochet::cli
