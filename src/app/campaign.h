#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/analysis/results.h"
#include "src/app/command_line.h"
#include "src/experiment/campaign.h"
#include "src/experiment/plan.h"
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

/// Adds the plan that a command takes, for plan_named().
void add_plan_file(CLI::App* command, std::string& plan);

/// Returns the plan of a file, or one of the plans that are included.
Plan plan_named(const std::string& name);

/// The programs and shared libraries that a plan names as solvers, each once, in their order.
/// Starts none. Throws InputError for one that does not exist.
std::vector<std::string> programs_of(const Plan& plan);

/// The catalogue of the suite that starts no program: see outside::unstarted_solver.
Catalogue catalogue_that_starts_nothing();

/// Says which programs will be started. Throws InputError, which names `origin`, if they are not
/// allowed: a file from elsewhere must not start programs unasked.
void announce_programs(const std::vector<std::string>& programs, bool allowed,
                       const std::string& origin);

/// The file of an archive: that of the reference's runs, which is included, for the name "archive".
std::string archive_named(const std::string& name);

/// The plan that compares the user's solvers with those of an archive, on the problems that fit the
/// patterns, or on all without any. If `out` has no store yet,
/// makes it, with the archive's runs. Writes to standard error which solvers of the archive this
/// build lacks, or has in another version.
Plan plan_against_archive(const std::string& archive, const std::vector<std::string>& own_solvers,
                          const std::vector<std::string>& problems, const Catalogue& catalogue,
                          const std::string& out);

/// Prints how far two stores or archives order their entries alike, by family, and which entries
/// changed from the first to the second: see entry_changes().
int compare_stores(const std::string& first, const std::string& second, bool json);

/// How many runs from elsewhere are repeated before they are taken.
struct Verification {
  int runs = 20;  ///< drawn at random among those that this build can repeat; 0: none
  bool allow_programs = false;
};

void add_verification(CLI::App* command, Verification& verification);

/// Repeats a random sample of the wanted runs of some stores. Returns in words, for the store that
/// they come to, how many there are, how many were repeated, the user and the date. Throws
/// InputError, naming file and run, if one differs from what is stored, by a bit.
std::string verified(const std::vector<std::string>& files,
                     const std::function<bool(const RunKey&)>& wanted,
                     const Verification& verification);

/// Writes to standard error why runs may be missing in a store, if so.
void warn_of_missing_runs(const std::string& store);

/// Checks a store, which was read from `file`, as check_content() does. Returns its campaign;
/// writes to standard error why this build cannot make it, if so, and returns nothing.
std::optional<Campaign> check_as_known(const Store& store, const std::string& file);

/// How complete a store is, which was read from `file`. Writes to standard error what is missing,
/// if anything is, or why this build cannot tell; then returns nothing. Throws InputError as
/// check_content() does.
std::optional<Completeness> told_completeness(const Store& store, const std::string& file);

/// "24 runs", or "16 of 24 planned runs" if some are missing.
std::string counted_runs(const Store& store, const std::optional<Completeness>& completeness);

}  // namespace ricochet::cli
