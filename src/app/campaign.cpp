#include "src/app/campaign.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "ricochet/error.h"
#include "src/analysis/comparison/study.h"
#include "src/app/command_line.h"
#include "src/app/other_program.h"
#include "src/core/child_process.h"
#include "src/core/files.h"
#include "src/core/names.h"
#include "src/core/progress.h"
#include "src/experiment/archived_campaign.h"
#include "src/experiment/planned_runs.h"
#include "src/experiment/worker.h"
#include "src/report/text.h"
#include "src/studies/suite/suite.h"

namespace ricochet::cli {

namespace {

Shard shard_of(const std::string& text) {
  const auto slash = text.find('/');
  if (slash != std::string::npos) {
    const auto index = number_of_text<int>(text.substr(0, slash));
    const auto count = number_of_text<int>(text.substr(slash + 1));
    if (index && count && *index >= 1 && *index <= *count) return {*index, *count};
  }
  throw InputError(
      fmt::format("--shard {}: must be I/N, two whole numbers with 1 <= I <= N", text));
}

/// Says how long a campaign will take that is made here.
void announce_time(const Campaign& campaign, const Shard& shard) {
  Forecast forecast = forecast_of(campaign);
  forecast.runs /= shard.count;
  if (shard.count > 1) forecast.report = 0;  // there is none of a part
  Progress::announce(in_words(forecast, cores()));
}

/// Returns true if mpirun started this process as one of several, by the environment variables of
/// Open MPI and of MPICH and its derivatives.
bool started_with_other_ranks() {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    const char* ranks = std::getenv(name);
    if (ranks != nullptr && std::atoi(ranks) > 1) return true;
  }
  return false;
}

/// Replaces this process by the program that distributes runs over ranks.
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
  for (const std::string& store : options.from) {
    arguments.insert(arguments.end(), {"--from", store});
  }
  if (options.allow_programs) arguments.emplace_back("--allow-programs");
  hand_over(mpi, arguments);
}

int run_plan(const RunOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  if (options.jobs < 0) throw InputError(fmt::format("--jobs {}: must be >= 0", options.jobs));
  const Shard shard = shard_of(options.shard);
  if (options.serve.empty() && started_with_other_ranks()) hand_over_to_mpi(options);
  std::optional<tbb::global_control> limited;
  if (options.jobs > 0) {
    limited.emplace(tbb::global_control::max_allowed_parallelism, options.jobs);
  }
  const Plan plan = plan_named(options.plan);
  if (options.serve == "runs") Progress::silence();  // the process with the store shows progress
  announce_programs(programs_of(plan), options.allow_programs, options.plan);
  if (options.serve == "runs") {
    const Campaign campaign = searched_campaign(plan, studies::whole_catalogue());
    fcntl(frames_out, F_SETFD, FD_CLOEXEC);  // child processes of the runs must not inherit it
    serve_runs(campaign, shard, STDIN_FILENO, frames_out);
    return 0;
  }
  const auto [campaign, store] =
      carried_out(plan, studies::whole_catalogue(), shard, options, "--resume");
  std::string digest;
  std::vector<std::string> failures;
  if (store.size() == campaign.runs()) {
    const auto study = studies::comparison_study(campaign, store);
    const studies::Finished finished = studies::run(study, false, options.out, start);
    fmt::print("{}", finished.epilogue);
    digest = finished.data["values"]["digest"].get<std::string>();
    failures = finished.failures;
  } else {
    digest = store.digest();
  }
  const std::string file = (std::filesystem::path(options.out) / "runs.sqlite").string();
  const Completeness completeness = completeness_of(campaign, store);
  if (completeness.missing() > 0) Progress::announce(in_words(completeness));
  fmt::print("{}: {}\ndigest {}\n", counted_runs(store, completeness), one_line(file), digest);
  report::require_none(failures);
  return 0;
}

}  // namespace

void add_run(CommandLine& line) {
  CLI::App* command = line.add("run", "Run a plan; every finished run is stored at once",
                               "  ricochet run plan.toml --out mine\n"
                               "  ricochet run plan.toml --out mine --resume\n"
                               "  ricochet run plan.toml --out part-3 --shard 3/8\n"
                               "  mpirun -n 64 ricochet run plan.toml --out mine");
  const auto options = std::make_shared<RunOptions>();
  add_plan_file(command, options->plan);
  add_value(command, "--out", options->out, "Folder of the store, runs.sqlite", "FOLDER");
  add_value(command, "--shard", options->shard, "Only the I-th of N parts of the runs", "I/N");
  CLI::Option* resume =
      command->add_flag("--resume", options->resume, "Continue the campaign in this folder");
  add_value(command, "--from", options->from,
            "Take over the runs of another store whose problem and solver are the same; may "
            "be repeated",
            "STORE")
      ->allow_extra_args(false)
      ->excludes(resume);
  add_allowance(command, options->allow_programs);
  add_value(command, "--jobs", options->jobs, "Runs in parallel; 0: as many as cores");
  command->add_option("--serve", options->serve, "What this process does under MPI")
      ->check(CLI::IsMember({"store", "runs"}))
      ->group("");  // hidden
  line.on_call(command, [options] { return run_plan(*options); });
}

StoredCampaign carried_out(const Plan& plan, const Catalogue& catalogue, const Shard& shard,
                           const RunOptions& options, std::string_view continuation) {
  // Before anything is written. The store has a folder, locks, a log and temporary files.
  constexpr int for_store = 8;
  allow_further_open_files(for_store + open_files_of_runs(processes_of_runs()));
  const FolderLock alone(options.out);
  const auto file = std::filesystem::path(options.out) / "runs.sqlite";
  if (std::filesystem::is_symlink(file)) {
    throw InputError(fmt::format("{}: is a link: give the folder that it leads to", file.string()));
  }
  const bool existed = std::filesystem::exists(file);
  if (!existed && options.resume && continuation == "--resume") {
    Progress::announce(fmt::format(
        "{}: is not there: there is nothing to resume, all runs are made", file.string()));
  }
  if (existed && !options.resume) {
    throw InputError(file.string() +
                     ": is there already: --resume goes on with it, and another "
                     "--out starts again");
  }
  const auto announce = [&](const Campaign& campaign) {
    Progress::announce(in_words(size_of(campaign)));
    if (options.serve.empty()) announce_time(campaign, shard);
  };
  const std::string how_to_go_on = fmt::format("finished runs are kept: {} goes on", continuation);
  StoredCampaign stored = [&] {
    const AtInterruption beforehand(
        [] {}, existed ? how_to_go_on : "no run was made: the same command starts again");
    if (!options.from.empty()) {
      std::vector<std::filesystem::path> earlier;
      for (const std::string& store : options.from) earlier.push_back(archive_named(store));
      start_from(earlier, searched_campaign(plan, catalogue), provenance(), file);
    }
    return stored_campaign(plan, catalogue, file, provenance(), announce);
  }();
  const auto& [campaign, store] = stored;
  if (existed || !options.from.empty()) Progress::announce(in_words(size_of(campaign)));
  if (store.size() > 0)
    Progress::announce(fmt::format("{} {} there already", report::counted(store.size(), "run"),
                                   store.size() == 1 ? "is" : "are"));
  if (options.serve.empty() && store.size() == campaign.runs()) return stored;
  const AtInterruption kept([] {}, how_to_go_on);
  if (options.serve.empty()) {
    make_runs(campaign, shard, stored.store);
  } else if (!serve_store(campaign, shard, stored.store, STDIN_FILENO, frames_out)) {
    throw std::runtime_error(
        fmt::format("not all runs were made; finished ones are kept: {} goes on", continuation));
  }
  return stored;
}

using report::Json;

std::string duration(double seconds) {
  if (seconds < 90) return fmt::format("{:.2g} s", std::max(seconds, 0.1));
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  if (seconds < 48 * 3600) return fmt::format("{:.1f} h", seconds / 3600);
  return fmt::format("{:.1f} days", seconds / 86400);
}

Json size_of(const Campaign& campaign) {
  double evaluations = 0;
  std::map<std::string, int> perturbations;
  for (const PlannedCell& cell : campaign.cells()) {
    evaluations += static_cast<double>(cell.budget.evaluations) * cell.instances * cell.seeds;
    ++perturbations[cell.cell.perturbation];
  }
  return {{"name", campaign.plan().name},
          {"problems", campaign.problems().size()},
          {"solvers", campaign.solvers().size()},
          {"perturbations", perturbations.size()},
          {"cells", campaign.cells().size()},
          {"runs", campaign.runs()},
          {"evaluations", evaluations},
          {"simulations", campaign.work()},
          {"to_search", campaign.to_search().size()}};
}

std::string in_words(const Json& size) {
  const auto to_search = size["to_search"].get<int>();
  return fmt::format(
      "{} of {} on {}, at most {:.3g} evaluations{}", report::counted(size["runs"], "run"),
      report::counted(size["solvers"], "solver"), report::counted(size["problems"], "problem"),
      size["evaluations"].get<double>(),
      to_search > 0
          ? fmt::format("; {} to be searched first", report::counted(to_search, "best value"))
          : "");
}

std::string in_words(const Forecast& forecast, int cores) {
  const double seconds = forecast.seconds(cores);
  return fmt::format("{} {} on {}", forecast.at_least ? "at least" : "about",
                     seconds < 1 ? "a second" : duration(seconds), report::counted(cores, "core"));
}

FinishedCampaign finished_campaign(const Store& store) {
  Campaign campaign = recorded_campaign(store);
  auto results = comparison::cell_results(campaign, store, [](const StoredRun&) {});
  return {std::move(campaign), std::move(results)};
}

namespace {

using RecordedSolvers = std::map<std::string, Solver>;  ///< by the plan's text for each

/// The user's solvers of a store, able to do what they said of themselves; where an earlier version
/// made the store, all that they could say.
RecordedSolvers recorded_solvers_of(const CampaignDescription& description) {
  RecordedSolvers own;
  for (const StoredSolver& stored : description.solvers) {
    const auto text = description.made.find(StoredCampaign::program_key(stored.name));
    if (text == description.made.end()) continue;
    Solver& solver = own[text->second];
    solver.name = stored.name;
    solver.version = stored.version;
    solver.content = stored.content;
    const auto taken = description.made.find(StoredCampaign::capabilities_key(stored.name));
    if (taken != description.made.end())
      solver.capabilities = capabilities_from(taken->second);
    else
      solver.capabilities.constraints = Capabilities::Constraints::all;
    solver.solve = [](Evaluator&, const Vector&, Random&) -> SolverTermination {
      throw std::logic_error("a recorded solver was started");
    };
  }
  return own;
}

/// The plan of a store, with those of its user's solvers that were recorded.
Plan plan_with(const RecordedSolvers& own, const CampaignDescription& description,
               const Catalogue& catalogue) {
  const Plan stored = plan_from(description.plan, "the store's plan");
  Plan plan = plan_against(description, {}, catalogue);
  for (std::size_t part = 0; part < plan.parts.size(); ++part) {
    for (const std::string& text : stored.parts[part].solvers) {
      if (own.contains(text)) plan.parts[part].solvers.push_back(text);
    }
  }
  return plan;
}

/// What the solver of this name takes, by the problems that it has runs on.
Capabilities capabilities_of(const std::string& solver, const Campaign& most,
                             const std::set<Cell>& run) {
  Capabilities shown;
  bool all_have_derivatives = true, all_have_residuals = true;
  for (const PlannedCell& cell : most.cells()) {
    if (cell.cell.solver != solver || !run.contains(cell.cell)) continue;
    Problem problem = most.problems()[cell.problem].formulated(cell.formulation);
    if (cell.perturbation) problem = cell.perturbation->perturbed(problem, 0);
    if (problem.constraints > 0) {
      shown.constraints = std::max(
          shown.constraints, problem.equalities > 0 ? Capabilities::Constraints::all
                                                    : Capabilities::Constraints::inequalities);
    }
    all_have_derivatives = all_have_derivatives && problem.differentiate;
    all_have_residuals = all_have_residuals && problem.residuals;
  }
  if (all_have_derivatives) shown.derivatives = Capabilities::Order::gradient;
  shown.needs_residuals = all_have_residuals;
  return shown;
}

}  // namespace

Campaign recorded_campaign(const Store& store) {
  const CampaignDescription& description = store.description();
  RecordedSolvers own = recorded_solvers_of(description);
  Catalogue catalogue = studies::whole_catalogue();
  catalogue.own_solver = [&own](const std::string& text) -> std::optional<Solver> {
    const auto place = own.find(text);
    return place == own.end() ? std::nullopt : std::optional(place->second);
  };
  const Plan plan = plan_with(own, description, catalogue);
  Campaign campaign = campaign_of(description, plan, catalogue);
  const auto is_recorded = [&](const auto& text_and_solver) {
    const std::string& name = text_and_solver.second.name;
    return description.made.contains(StoredCampaign::capabilities_key(name));
  };
  if (std::ranges::all_of(own, is_recorded)) return campaign;
  std::set<Cell> run;
  for (const RunKey& key : store.keys()) run.insert(key.cell);
  for (auto& entry : own) {
    if (is_recorded(entry)) continue;
    entry.second.capabilities = capabilities_of(entry.second.name, campaign, run);
  }
  return campaign_of(description, plan, catalogue);
}

}  // namespace ricochet::cli
