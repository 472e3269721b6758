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
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <optional>

#include "embedded/default_plan.h"
#include "embedded/full_plan.h"
#include "embedded/plan_template.h"
#include "embedded/quick_plan.h"
#include "embedded/slurm_template.h"
#include "src/campaign/forecast.h"
#include "src/campaign/frame.h"
#include "src/campaign/runner.h"
#include "src/campaign/service.h"
#include "src/cli/other_program.h"
#include "src/cli/version.h"
#include "src/core/error.h"
#include "src/core/folder_lock.h"
#include "src/report/filled_text.h"
#include "src/report/json.h"
#include "src/store/stored_parts.h"
#include "src/studies/contest/catalogue.h"

namespace ricochet::cli {
namespace {

using report::Json;

int cores() {
  return static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

std::string duration(double seconds) {
  if (seconds < 90) return fmt::format("{:.2g} s", std::max(seconds, 0.1));
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 48 * 3600) return fmt::format("{:.1f} h", seconds / 3600);
  return fmt::format("{:.1f} days", seconds / 86400);
}

/// What a campaign runs, in numbers.
Json size_of(const Campaign& campaign) {
  double evaluations = 0;
  std::map<std::string, int> features;
  for (const PlannedCell& cell : campaign.cells()) {
    evaluations += static_cast<double>(cell.budget.evaluations) * cell.instances * cell.seeds;
    ++features[cell.cell.feature];
  }
  return {{"name", campaign.plan().name},         {"questions", campaign.questions().size()},
          {"solvers", campaign.solvers().size()}, {"features", features.size()},
          {"cells", campaign.cells().size()},     {"runs", campaign.runs()},
          {"evaluations", evaluations},           {"simulations", campaign.work()}};
}

std::string in_words(const Json& size) {
  return fmt::format("{} runs of {} solvers on {} questions, at most {:.3g} evaluations",
                     size["runs"].get<std::int64_t>(), size["solvers"].get<int>(),
                     size["questions"].get<int>(), size["evaluations"].get<double>());
}

/// A word of a shell, whatever it has in it.
std::string in_shell_quotes(const std::string& word) {
  std::string quoted = "'";
  for (const char c : word) {
    if (c == '\'') {
      quoted += "'\\''";
    } else {
      quoted += c;
    }
  }
  return quoted + "'";
}

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

/// A file, or one of the plans that come along.
Plan plan_named(const std::string& name) {
  if (name == "quick") return plan_from(embedded::quick_plan, name);
  if (name == "default") return plan_from(embedded::default_plan, name);
  if (name == "full") return plan_from(embedded::full_plan, name);
  return read_plan(name);
}

/// The store to go on with: of this campaign, made by this program; by any where no run is missing,
/// for its report alone. Another one stays as it is.
Store store_to_resume(const std::filesystem::path& file, const Campaign& campaign,
                      const CampaignDescription& description) {
  Store found = Store::open(file, Store::For::reading);
  CampaignDescription theirs = found.description();
  theirs.made = description.made;
  if (theirs == description) return Store::open(file, Store::For::adding);
  const bool whole = found.size() == static_cast<std::int64_t>(campaign.runs());
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
  fmt::print(stderr, "{}\n", in_words(size_of(campaign)));
  if (before > 0) fmt::print(stderr, "{} runs are there already\n", before);
  if (options.serve.empty()) {
    if (before == 0) {
      fmt::print(stderr, "about {} on {} cores\n",
                 duration(foretold_seconds(campaign) / shard.count / cores()), cores());
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

int new_plan() {
  fmt::print("{}", embedded::plan_template);
  return 0;
}

int check_plan(const std::string& plan, bool json) {
  const Campaign campaign(plan_named(plan), studies::whole_catalogue());
  Json size = size_of(campaign);
  const double seconds = foretold_seconds(campaign);
  size["seconds"] = seconds;
  size["cores"] = cores();
  if (json) {
    fmt::print("{}\n", size.dump(2));
  } else {
    fmt::print("{}; about {} on {} cores\n", in_words(size), duration(seconds / cores()), cores());
  }
  return 0;
}

int slurm_script(const std::string& plan, int jobs) {
  if (jobs < 1 || jobs > 10'000) {
    throw InputError(fmt::format("--jobs {}: must be from 1 to 10000", jobs));
  }
  if (plan == "-") throw InputError("the jobs read the plan: it must be a file");
  const Campaign campaign(plan_named(plan), studies::whole_catalogue());
  const double hours = foretold_seconds(campaign) / jobs / 3600;
  const Json data = {{"plan", in_shell_quotes(plan)},
                     {"jobs", jobs},
                     {"hours", static_cast<int>(std::ceil(2 * hours + 0.1))}};
  fmt::print("{}", report::filled(embedded::slurm_template, {&data}));
  return 0;
}

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
  if (store.size() == campaign.runs()) {
    const auto study = studies::contest_study(campaign, store, false);
    fmt::print("{}", studies::run(study, false, options.out).epilogue);
  }
  fmt::print("{} runs: {}\ndigest {}\n", store.size(),
             (std::filesystem::path(options.out) / "runs.sqlite").string(), store.digest());
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

int merge_stores(const std::vector<std::string>& parts, const std::string& out) {
  merge({parts.begin(), parts.end()}, out);
  const Store store = Store::open(out, Store::For::reading);
  fmt::print("{} runs: {}\ndigest {}\n", store.size(), out, store.digest());
  return 0;
}

int print_digest(const std::string& store) {
  fmt::print("{}\n", Store::open(store, Store::For::reading).digest());
  return 0;
}

int replay(const std::string& file, std::int64_t number, bool json) {
  const Store store = Store::open(file, Store::For::reading);
  const auto stored = store.find(number);
  if (!stored) {
    throw InputError(fmt::format("{}: there is no run {}: {} has runs 1 to {}", number, number,
                                 file, store.size()));
  }
  const Campaign campaign(plan_from(store.description().plan, file), studies::whole_catalogue());
  const PlannedRuns planned(campaign, {}, {});
  const auto run = std::find_if(planned.all().begin(), planned.all().end(),
                                [&](const PlannedRun& r) { return r.key == stored->key; });
  if (run == planned.all().end()) {
    throw InputError(fmt::format("{}: run {} is none of its plan's", file, number));
  }
  RunRecord again;
  run_all({run->job}, campaign.plan().limits,
          [&](std::size_t, RunRecord record) { again = std::move(record); });
  const std::string differs = difference(parts_of(again), parts_of(stored->record));
  const Cell& cell = stored->key.cell;
  const Json data = {
      {"run", number},
      {"question", cell.question},
      {"form", cell.form},
      {"feature", cell.feature},
      {"solver", cell.solver},
      {"budget", cell.budget},
      {"gradient_price", cell.gradient_price},
      {"instance", stored->key.instance},
      {"seed", stored->key.run},
      {"failure", again.failure},
      {"evaluations", again.ledger.charged},
      {"objective", again.trace.empty() ? Json() : Json(again.trace.back().truth.objective)},
      {"differs", differs},
      {"same", differs.empty()}};
  if (json) {
    fmt::print("{}\n", data.dump(2));
  } else {
    fmt::print("{} on {}, shown {}, feature {}, instance {}, seed {}: {} evaluations{}.\n{}\n",
               cell.solver, cell.question, cell.form, cell.feature, stored->key.instance,
               stored->key.run, again.ledger.charged,
               again.failure.empty() ? "" : "; " + again.failure,
               differs.empty() ? "The same, to the last bit."
                               : "NOT the same as stored: it differs in " + differs + ".");
  }
  return differs.empty() ? 0 : 1;
}

}  // namespace ricochet::cli
