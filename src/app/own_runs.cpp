#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <functional>
#include <map>
#include <utility>

#include "ricochet/error.h"
#include "solvers/outside/outside.h"
#include "src/app/own_comparison.h"
#include "src/app/problem_choice.h"
#include "src/core/names.h"
#include "src/core/progress.h"
#include "src/experiment/campaign.h"
#include "src/experiment/perturbations.h"
#include "src/experiment/worker.h"
#include "src/report/text.h"

namespace ricochet::cli {

namespace {

using own::OwnProblem;
using report::counted;
using Clock = std::chrono::steady_clock;

constexpr std::int64_t usual_budget = 100;  // [evaluations] of a run for each variable
/// [s] that an evaluation takes beside the program, on one core: the store and the solver. Measured
/// as the mean over all entries with examples/problems/spring.toml.
constexpr double overhead = 1e-4;

void check_own(const OwnComparisonOptions& options) {
  const auto within = [](const char* option, std::int64_t number, std::int64_t least,
                         std::int64_t most) {
    if (number < least || number > most)
      throw InputError(fmt::format("{} {}: must be within {}..{}", option, number, least, most));
  };
  const std::vector<std::int64_t>& budgets = options.compared.budgets;
  if (budgets.size() > 1) throw InputError("--budget: must be one number for problem files");
  if (!budgets.empty()) within("--budget", budgets.front(), 1, 1'000'000);
  within("--starts", options.starts, 1, 100);
  within("--evaluations", options.evaluations.value_or(1), 1, 1'000'000'000'000);
  within("--workers", options.workers, 0, 1000);
  if (options.seconds && !(*options.seconds > 0 && *options.seconds < 1e8)) {
    throw InputError(fmt::format("--seconds {}: must be > 0 and < 1e8", *options.seconds));
  }
  check(options.compared.limits);
}

std::vector<OwnEntry> entries_for(const OwnComparisonOptions& options, const Problem& problem) {
  Catalogue catalogue;
  catalogue.solvers = all_solvers();
  catalogue.own_solver = outside::outside_solver;
  std::map<std::string, std::string> own_texts;
  std::vector<std::string> texts = split_patterns(options.compared.solvers);
  const std::vector<std::string>& added = options.compared.added_solvers;
  texts.insert(texts.end(), added.begin(), added.end());

  const std::vector<std::string> patterns = split_patterns(options.compared.formulations);
  std::vector<std::string> names;
  for (const Formulation& each : problem.formulations()) names.push_back(problem.name_of(each));
  require_fit(patterns, names, "--formulations");
  const bool first_alone = options.compared.formulations == "*";
  std::vector<OwnEntry> entries;
  for (const Solver& solver : solvers_of(texts, catalogue, own_texts, "--solvers")) {
    for (const Formulation& formulation : problem.formulations()) {
      const std::string name = problem.name_of(formulation);
      if (!fits_any(name, patterns) || !solver.accepts(problem.formulated(formulation))) continue;
      entries.push_back({solver, formulation, name});
      if (first_alone) break;  // it is the nearest to the problem
    }
  }
  if (entries.empty()) throw InputError(problem.name + ": none of these solvers accepts it");
  return entries;
}

/// One run that is to be made.
struct PlannedRun {
  const OwnEntry* entry;
  int start;
  std::int64_t budget;
};

/// Makes runs, side by side, and adds their evaluations to `counts`. `made` is called after each.
std::vector<OwnRun> make_own_runs(OwnRuns& all, const std::vector<PlannedRun>& planned,
                                  const Limits& limits, const std::function<void()>& made) {
  std::deque<OwnProblem> asking;  // each counts its own evaluations
  std::deque<Problem> seen;
  std::vector<Job> jobs;
  for (const PlannedRun& run : planned) {
    // The name is that by which `solve` asks with the same options.
    asking.push_back(all.own.of_run(fmt::format("{} {} instance 0 seed {}", run.entry->solver.name,
                                                run.entry->formulation_name, run.start)));
    seen.push_back(asking.back().problem().formulated(run.entry->formulation));
    Budget budget{run.budget};
    budget.gradient_price = all.own.problem().gradient_cost;
    jobs.push_back({&seen.back(), &run.entry->solver, budget, run.start,
                    shown_as(run.entry->formulation_name, "plain")});
  }
  all.own.store().close();  // the processes of the runs open it themselves
  std::vector<OwnRun> runs(jobs.size());
  run_all(jobs, limits, [&](std::size_t job, RunRecord record) {
    runs[job] = {std::move(record), asking[job].counts()};
    all.counts += runs[job].counts;
    made();
  });
  return runs;
}

/// Shares evaluations out so that every entry gets the same. There are as many rounds, up to
/// `starts`, as have runs of the usual budget; then runs share what is there. What does not suffice
/// for one evaluation more of each run is left.
void share_out(OwnRuns& all, std::int64_t evaluations, int starts) {
  const auto entries = static_cast<std::int64_t>(all.entries.size());
  const std::int64_t round = entries * usual_budget * all.own.problem().dimension();
  all.rounds = static_cast<int>(std::clamp<std::int64_t>(evaluations / round, 1, starts));
  all.budget = evaluations / (entries * all.rounds);
}

/// What an evaluation costs [s], by the starts, which all entries evaluate anyway.
double measured_cost(OwnRuns& all, const Limits& limits) {
  constexpr int trials = 5;
  const OwnEntry trial{solver_named("random-search", "a measurement"), {}, "measurement"};
  std::vector<PlannedRun> planned;
  for (int k = 0; k < trials; ++k) planned.push_back({&trial, k, 1});
  std::vector<double> seconds;
  for (const OwnRun& run : make_own_runs(all, planned, limits, [] {})) {
    seconds.push_back(run.counts.seconds);
  }
  std::nth_element(seconds.begin(), seconds.begin() + trials / 2, seconds.end());
  return seconds[trials / 2] + overhead;
}

/// Sets rounds and budget by the options. `seconds` is this file's part of the time.
void plan_runs(OwnRuns& all, const OwnComparisonOptions& options, std::int64_t files,
               double seconds, const Limits& limits) {
  const auto entries = static_cast<std::int64_t>(all.entries.size());
  if (options.evaluations) {
    const std::int64_t evaluations = *options.evaluations / files;
    if (evaluations < entries) {
      throw InputError(fmt::format("--evaluations {}: must be at least {}, one for each entry",
                                   *options.evaluations, entries * files));
    }
    share_out(all, evaluations, options.starts);
  } else if (options.seconds) {
    const auto at_once =
        static_cast<double>(std::min(processes_of_runs(), static_cast<std::size_t>(entries)));
    const double fit = seconds * at_once / measured_cost(all, limits);
    share_out(all, std::max(entries, static_cast<std::int64_t>(fit)), options.starts);
  } else {
    const std::vector<std::int64_t>& budgets = options.compared.budgets;
    all.rounds = options.starts;
    all.budget = (budgets.empty() ? usual_budget : budgets.front()) * all.own.problem().dimension();
  }
}

}  // namespace

OwnRuns own_runs(const OwnComparisonOptions& options, const std::string& file) {
  check_own(options);
  std::optional<tbb::global_control> limited;
  if (options.workers > 0) {
    limited.emplace(tbb::global_control::max_allowed_parallelism, options.workers);
  }
  OwnRuns all{*choose_problem({file, "", {}, options.allow_programs}, "compare").own};
  all.entries = entries_for(options, all.own.problem());
  Limits limits = options.compared.limits;
  limits.megabytes += all.own.file().program.megabytes;
  const auto files = static_cast<std::int64_t>(split_patterns(options.compared.problems).size());
  const double seconds = options.seconds.value_or(0) / static_cast<double>(files);
  const auto begun = Clock::now();
  const auto time_is_over = [&] {
    return options.seconds && std::chrono::duration<double>(Clock::now() - begun).count() > seconds;
  };
  plan_runs(all, options, files, seconds, limits);

  const auto entries = static_cast<std::int64_t>(all.entries.size());
  Progress::announce(fmt::format("{} of {} from {}, {} each", counted(entries * all.rounds, "run"),
                                 counted(entries, "entry", "entries"), counted(all.rounds, "start"),
                                 counted(all.budget, "evaluation")));
  const AtInterruption kept(
      [] {}, all.own.store_path().string() + " keeps the evaluations: the same command goes on");
  Progress progress("comparing solvers on " + all.own.problem().name,
                    static_cast<double>(entries * all.rounds));
  for (int round = 0; round < all.rounds && !(round > 0 && time_is_over());) {
    std::vector<PlannedRun> planned;
    // Only a limit of time waits for the end of each round.
    const int end = options.seconds ? round + 1 : all.rounds;
    for (; round < end; ++round) {
      for (const OwnEntry& entry : all.entries) planned.push_back({&entry, round, all.budget});
    }
    std::vector<OwnRun> made =
        make_own_runs(all, planned, limits, [&progress] { progress.advance(1); });
    for (auto run = made.begin(); run != made.end(); run += entries) {
      all.runs.emplace_back(std::make_move_iterator(run), std::make_move_iterator(run + entries));
    }
  }
  return all;
}

}  // namespace ricochet::cli
