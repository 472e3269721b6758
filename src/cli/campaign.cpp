#include "src/cli/campaign.h"

#include <fcntl.h>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <optional>

#include "src/campaign/forecast.h"
#include "src/campaign/frame.h"
#include "src/campaign/planned_runs.h"
#include "src/campaign/progress.h"
#include "src/campaign/service.h"
#include "src/cli/campaign_size.h"
#include "src/cli/other_program.h"
#include "src/cli/plan.h"
#include "src/cli/version.h"
#include "src/core/error.h"
#include "src/core/folder_lock.h"
#include "src/studies/contest/catalogue.h"

namespace ricochet::cli {
namespace {

Shard shard_of(const std::string& text) {
  Shard shard;
  const auto slash = text.find('/');
  const char* end = text.data() + text.size();
  if (slash != std::string::npos) {
    const char* middle = text.data() + slash;
    const auto first = std::from_chars(text.data(), middle, shard.index);
    const auto second = std::from_chars(middle + 1, end, shard.count);
    const bool read = first.ec == std::errc() && first.ptr == middle && second.ec == std::errc() &&
                      second.ptr == end;
    if (read && shard.index >= 1 && shard.index <= shard.count) return shard;
  }
  throw InputError(
      fmt::format("--shard {}: must be I/N, two whole numbers with 1 <= I <= N", text));
}

/// What made a store: the same for all its parts.
std::map<std::string, std::string> program() {
  return {{"version", version()}};
}

std::map<std::string, std::string> made_here() {
  utsname machine{};
  uname(&machine);
  return {{"machine", fmt::format("{} {}, {}", machine.sysname, machine.release, machine.machine)},
          {"cores", std::to_string(cores())},
          {"date", fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::time(nullptr)))}};
}

CampaignDescription description_of(const Campaign& campaign) {
  CampaignDescription description = campaign.description();
  description.program = program();
  description.made = made_here();
  return description;
}

/// The store to go on with: of this campaign, made by this program; by any where no run is missing,
/// for its report alone. Another one stays as it is.
Store store_to_resume(const std::filesystem::path& file, const Campaign& campaign,
                      const CampaignDescription& description) {
  Store found = Store::open(file, Store::For::reading);
  CampaignDescription theirs = found.description();
  theirs.made = description.made;
  const bool whole = found.size() == campaign.runs();
  if (theirs == description)
    return whole ? std::move(found) : Store::open(file, Store::For::adding);
  const bool same_program =
      std::exchange(theirs.program, description.program) == description.program;
  if (whole && theirs == description) return found;
  const char* what = theirs.plan != description.plan ? "of another plan"
                     : !same_program                 ? "made by another program"
                                                     : "of other questions or solvers";
  throw InputError(fmt::format("{}: is {}: another --out begins anew", file.string(), what));
}

/// Makes the runs that the folder's store lacks, or has the other ranks make them.
Store carried_out(const Campaign& campaign, const Shard& shard, const RunOptions& options) {
  const FolderLock alone(options.out);
  const auto file = std::filesystem::path(options.out) / "runs.sqlite";
  const bool there = std::filesystem::exists(file);
  if (there && !options.resume) {
    throw InputError(file.string() +
                     ": is there already: --resume goes on with it, and another "
                     "--out begins anew");
  }
  const CampaignDescription description = description_of(campaign);
  Store store =
      there ? store_to_resume(file, campaign, description) : Store::create(file, description);
  const std::int64_t before = store.size();
  Progress::announce(in_words(size_of(campaign)));
  if (before > 0) Progress::announce(fmt::format("{} runs are there already", before));
  if (options.serve.empty() && before == campaign.runs()) return store;
  if (options.serve.empty()) {
    if (before == 0) {
      const double seconds = foretold_seconds(campaign) / shard.count / cores();
      Progress::announce(fmt::format("about {} on {} cores", duration(seconds), cores()));
    }
    make_runs(campaign, shard, store);
  } else if (!serve_store(campaign, shard, store, STDIN_FILENO, frames_out)) {
    throw std::runtime_error("not all runs were made; finished ones are kept: --resume goes on");
  }
  return store;
}

/// Whether mpirun has started this process as one of several; by what Open MPI, and MPICH and its
/// kin, tell it.
bool started_with_other_ranks() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const char* ranks = std::getenv(name);
    if (ranks != nullptr && std::atoi(ranks) > 1) return true;
  }
  return false;
}

/// Becomes the program that moves runs between ranks.
[[noreturn]] void hand_over_to_mpi(const RunOptions& options) {
  const OtherCommand mpi{"run", "ricochet-mpi", ""};
  if (options.plan == "-") throw InputError("under mpirun the plan must be a file");
  if (!std::filesystem::exists(path_of(mpi))) {
    throw InputError(
        "ricochet is built without MPI: -D RICOCHET_WITH_MPI=ON builds it with, and --shard needs "
        "none");
  }
  std::vector<std::string> arguments = {options.plan,
                                        "--out",
                                        options.out,
                                        "--shard",
                                        options.shard,
                                        "--jobs",
                                        std::to_string(std::max(1, options.jobs))};
  if (options.resume) arguments.emplace_back("--resume");
  hand_over(mpi, arguments);
}

}  // namespace

int run_plan(const RunOptions& options) {
  if (options.jobs < 0) throw InputError(fmt::format("--jobs {}: must be >= 0", options.jobs));
  const Shard shard = shard_of(options.shard);
  if (options.serve.empty() && started_with_other_ranks()) hand_over_to_mpi(options);
  std::optional<tbb::global_control> limited;
  if (options.jobs > 0) {
    limited.emplace(tbb::global_control::max_allowed_parallelism, options.jobs);
  }
  if (options.serve == "runs") {
    const Campaign campaign(plan_named(options.plan), studies::whole_catalogue());
    fcntl(frames_out, F_SETFD, FD_CLOEXEC);  // what runs start has no business with it
    serve_runs(campaign, shard, STDIN_FILENO, frames_out);
    return 0;
  }
  const Campaign campaign(plan_named(options.plan), studies::whole_catalogue());
  const Store store = carried_out(campaign, shard, options);
  std::string digest;
  if (store.size() == campaign.runs()) {
    const auto study = studies::contest_study(campaign, store, false);
    const studies::Finished report = studies::run(study, false, options.out);
    fmt::print("{}", report.epilogue);
    digest = report.data["digest"].get<std::string>();
  } else {
    digest = store.digest();
  }
  fmt::print("{} runs: {}\ndigest {}\n", store.size(),
             (std::filesystem::path(options.out) / "runs.sqlite").string(), digest);
  return 0;
}

int compare(const studies::ContestOptions& options, bool quick, const std::string& out) {
  const Catalogue catalogue = studies::whole_catalogue();
  const Campaign campaign(studies::contest_plan(options, quick, catalogue), catalogue);
  RunOptions here;
  here.out = out;
  here.resume = true;
  const Store store = carried_out(campaign, {}, here);
  const auto study = studies::contest_study(campaign, store, true);
  fmt::print("{}", studies::run(study, quick, out).epilogue);
  return 0;
}

}  // namespace ricochet::cli
