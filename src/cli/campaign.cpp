#include "src/cli/campaign.h"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <sys/utsname.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
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
#include "src/campaign/runner.h"
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
  return {{"name", campaign.plan().name},
          {"questions", campaign.questions().size()},
          {"solvers", campaign.solvers().size()},
          {"features", features.size()},
          {"cells", campaign.cells().size()},
          {"runs", campaign.runs()},
          {"evaluations", evaluations},
          {"simulations", campaign.work()},
          {"seconds", foretold_seconds(campaign)},
          {"cores", cores()}};
}

std::string in_words(const Json& size) {
  const double seconds = size["seconds"].get<double>() / size["cores"].get<double>();
  return fmt::format(
      "{} runs of {} solvers on {} questions, at most {:.3g} evaluations; about {} on {} cores\n",
      size["runs"].get<std::int64_t>(), size["solvers"].get<int>(), size["questions"].get<int>(),
      size["evaluations"].get<double>(), duration(seconds), size["cores"].get<int>());
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

/// The store to go on with: of this campaign, made by this program.
Store store_to_resume(const std::filesystem::path& file, const CampaignDescription& description) {
  Store store = Store::open(file, Store::For::adding);
  CampaignDescription theirs = store.description();
  theirs.made = description.made;
  if (theirs == description) return store;
  const char* what = theirs.plan != description.plan         ? "of another plan"
                     : theirs.program != description.program ? "made by another program"
                                                             : "of other questions or solvers";
  throw InputError(fmt::format("{}: is {}: another --out begins anew", file.string(), what));
}

/// Makes the runs that the folder's store lacks.
Store carried_out(const Campaign& campaign, const Shard& shard, const std::string& out,
                  bool resume) {
  const FolderLock alone(out);
  const auto file = std::filesystem::path(out) / "runs.sqlite";
  const bool there = std::filesystem::exists(file);
  if (there && !resume) {
    throw InputError(file.string() +
                     ": is there already: --resume goes on with it, and another "
                     "--out begins anew");
  }
  const CampaignDescription description = description_of(campaign);
  Store store = there ? store_to_resume(file, description) : Store::create(file, description);
  const std::int64_t before = store.size();
  if (before < campaign.runs() / shard.count) fmt::print(stderr, "{}", in_words(size_of(campaign)));
  if (before > 0) fmt::print(stderr, "{} runs are there already\n", before);
  make_runs(campaign, shard, store);
  return store;
}

}  // namespace

int new_plan() {
  fmt::print("{}", embedded::plan_template);
  return 0;
}

int check_plan(const std::string& plan, bool json) {
  const Campaign campaign(plan_named(plan), studies::whole_catalogue());
  const Json size = size_of(campaign);
  fmt::print("{}", json ? size.dump(2) + "\n" : in_words(size));
  return 0;
}

int slurm_script(const std::string& plan, int jobs) {
  if (jobs < 1 || jobs > 10'000) {
    throw InputError(fmt::format("--jobs {}: must be from 1 to 10000", jobs));
  }
  const Campaign campaign(plan_named(plan), studies::whole_catalogue());
  const double hours = foretold_seconds(campaign) / jobs / 3600;
  const Json data = {
      {"plan", plan}, {"jobs", jobs}, {"hours", static_cast<int>(std::ceil(2 * hours + 0.1))}};
  fmt::print("{}", report::filled(embedded::slurm_template, {&data}));
  return 0;
}

int run_plan(const RunOptions& options) {
  if (options.jobs < 0) throw InputError(fmt::format("--jobs {}: must be >= 0", options.jobs));
  std::optional<tbb::global_control> limited;
  if (options.jobs > 0) {
    limited.emplace(tbb::global_control::max_allowed_parallelism, options.jobs);
  }
  const Shard shard = shard_of(options.shard);
  const Campaign campaign(plan_named(options.plan), studies::whole_catalogue());
  const Store store = carried_out(campaign, shard, options.out, options.resume);
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
  const Store store = carried_out(campaign, {}, out, true);
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
