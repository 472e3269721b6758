#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "ricochet/evaluator.h"
#include "ricochet/run.h"
#include "src/core/child_process.h"
#include "src/core/files.h"
#include "src/core/progress.h"
#include "src/experiment/planned_runs.h"
#include "src/experiment/store.h"
#include "src/experiment/worker.h"

namespace ricochet {

namespace {

using Clock = std::chrono::steady_clock;

// What a report takes, in runs of one evaluation (seconds_of_a_run): of 20,000 of them, in one
// cell, it took 0.4 times their processor time more than an empty one, and of 5,552 cells 8 runs
// each; pages alone, on one core, take the rest.
constexpr double reported_run = 0.4;
constexpr double reported_cell = 8;
constexpr double pages = 1800;

/// Processor time [s] of this process and of the children that have ended.
double processor_seconds_with_children() {
  double seconds = 0;
  for (const int whose : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    getrusage(whose, &used);
    for (const timeval& time : {used.ru_utime, used.ru_stime}) {
      seconds += static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    }
  }
  return seconds;
}

/// Processor time [s] of a run beside its evaluations, on this machine: of its process, its
/// messages and its rows. Some runs of one evaluation are made into a store that is then removed.
double seconds_of_a_run() {
  constexpr int runs = 400;
  Problem problem;
  problem.name = "timed";
  problem.lower = problem.start = Vector::Zero(1);
  problem.upper = Vector::Ones(1);
  problem.evaluate = [](const Vector& x) { return Values{x[0], {}}; };
  Solver solver;
  solver.name = "timed";
  solver.solve = [](Evaluator& evaluator, const Vector& start, Random&) -> SolverTermination {
    evaluator.objective(start);
    return {"timed"};
  };
  const ScratchFolder folder;
  CampaignDescription description;
  StoredProblem& stored = description.problems.emplace_back();
  stored.name = problem.name;
  stored.variables = 1;
  description.solvers.push_back({solver.name, ""});
  Store store = Store::create(folder.path() / "runs.sqlite", description);
  std::vector<Job> jobs;
  for (int number = 0; number < runs; ++number) {
    jobs.push_back({&problem, &solver, Budget{1}, number});
  }
  const double before = processor_seconds_with_children();
  run_all(jobs, Limits{}, [&](std::size_t job, const RunRecord& record) {
    store.add({{problem.name, "original", "plain", solver.name, 1}, 1, jobs[job].number}, record);
  });
  return (processor_seconds_with_children() - before) / runs;
}

/// Most evaluations of a run that is made to time a solver.
constexpr std::int64_t most_timed = 1000;

double elapsed(Clock::time_point since) {
  return std::chrono::duration<double>(Clock::now() - since).count();
}

/// Mean time [s] of an evaluation at the start and at points between the corners of the box.
double seconds_of(const Problem& problem) {
  constexpr int places = 4;
  constexpr double longest = 0.1;
  Stopwatch stopwatch;
  int evaluations = 0;
  do {
    const int place = evaluations % (places + 1);
    const double share = (place - 0.5) / places;
    try {
      static_cast<void>(problem.evaluate(
          place == 0 ? problem.start
                     : Vector(problem.lower + share * (problem.upper - problem.lower))));
    } catch (const std::exception&) {
      // Only the time counts here.
    }
    ++evaluations;
  } while ((evaluations <= places && stopwatch.read() < longest) ||
           (evaluations < 100 && stopwatch.read() < 1e-3));
  return stopwatch.read() / evaluations;
}

/// What a solver takes [s].
struct SolverTime {
  double start = 0;       ///< its first run in a process, more than another one
  double evaluation = 0;  ///< its own time for each
};

/// Time [s] of an evaluation in a cell: where the solver does not see the true values, they are
/// evaluated, too.
double seconds_of(const PlannedCell& cell, const std::vector<double>& of_problem) {
  const bool perturbed = cell.cell.perturbation != "plain" && cell.perturbation != nullptr;
  const bool twice = cell.formulation.smoothing > 0 || perturbed;
  return (twice ? 2 : 1) * of_problem[cell.problem];
}

/// Times two runs of a cell's solver in a process of their own; nothing if they fail.
std::optional<SolverTime> time_of_solver(const Campaign& campaign, const PlannedCell& cell,
                                         double seconds_of_evaluation) {
  constexpr std::chrono::seconds longest(10);
  const Problem problem = campaign.problems()[cell.problem].formulated(cell.formulation);
  const Solver& solver = campaign.solvers()[cell.solver];
  // The time of a program is not that of this process.
  const bool by_clock = campaign.own_texts().contains(solver.name);
  Budget budget = cell.budget;
  budget.evaluations = std::min(budget.evaluations, most_timed);
  const auto two_runs = [&] {
    std::string times;
    for (int number = 0; number < 2; ++number) {
      const Clock::time_point start = Clock::now();
      Stopwatch stopwatch;
      const RunRecord record = run(problem, solver, budget, number);
      if (!record.failure.empty()) throw std::runtime_error(record.failure);
      times += fmt::format("{} {} ", by_clock ? elapsed(start) : stopwatch.read(),
                           std::max<std::int64_t>(1, record.ledger.charged));
    }
    return times;
  };
  double seconds[2] = {};
  double evaluations[2] = {};
  try {
    const std::string times =
        called_in_isolation(two_runs, longest, campaign.plan().limits.megabytes);
    std::sscanf(times.c_str(), "%lf %lf %lf %lf", &seconds[0], &evaluations[0], &seconds[1],
                &evaluations[1]);
  } catch (const std::exception&) {
    return std::nullopt;
  }
  return SolverTime{std::max(0.0, seconds[0] - seconds[1]),
                    std::max(0.0, seconds[1] / evaluations[1] - seconds_of_evaluation)};
}

std::vector<double> times_of_problems(const Campaign& campaign) {
  std::vector<double> times;
  Progress progress("timing problems", static_cast<double>(campaign.problems().size()));
  for (const Problem& problem : campaign.problems()) {
    times.push_back(problem.hazardous ? 0 : seconds_of(problem));
    progress.advance(1);
  }
  return times;
}

/// The cell with the shortest run of every solver; of a hazardous problem only if there is no
/// other.
std::vector<const PlannedCell*> shortest_cells(const Campaign& campaign,
                                               const std::vector<double>& of_problem) {
  std::vector<const PlannedCell*> shortest(campaign.solvers().size());
  const auto length = [&](const PlannedCell& cell) {
    if (campaign.problems()[cell.problem].hazardous) return std::numeric_limits<double>::max();
    return static_cast<double>(std::min(cell.budget.evaluations, most_timed)) *
           seconds_of(cell, of_problem);
  };
  for (const PlannedCell& cell : campaign.cells()) {
    const PlannedCell*& mine = shortest[cell.solver];
    if (mine == nullptr || length(cell) < length(*mine)) mine = &cell;
  }
  return shortest;
}

/// Evaluations of a scan of the whole box; 0 if it has several variables.
double evaluations_of_scan(const Problem& problem) {
  return problem.dimension() == 1 ? (problem.upper[0] - problem.lower[0]) / problem.scan_step : 0;
}

double seconds_of_report(const Campaign& campaign, const std::vector<double>& of_problem,
                         double of_a_run) {
  double seconds = of_a_run * (pages + reported_run * static_cast<double>(campaign.runs()) +
                               reported_cell * static_cast<double>(campaign.cells().size()));
  // Of a surrogate of one variable the best value is searched in a tenth of the scan's steps.
  for (std::size_t q = 0; q < of_problem.size(); ++q) {
    const Problem& problem = campaign.problems()[q];
    if (problem.smoothed) seconds += evaluations_of_scan(problem) / 10 * of_problem[q];
  }
  return seconds;
}

double seconds_of_search(const Campaign& campaign, const std::vector<double>& of_problem) {
  double seconds = 0;
  for (std::size_t q = 0; q < of_problem.size(); ++q) {
    const Problem& problem = campaign.problems()[q];
    if (campaign.to_search().contains(problem.name)) {
      seconds += evaluations_of_scan(problem) * of_problem[q];
    }
  }
  return seconds;
}

}  // namespace

double Forecast::seconds(double cores) const {
  return one_core + (search + runs + report - one_core) / cores;
}

Forecast forecast_of(const Campaign& campaign) {
  const std::vector<double> of_problem = times_of_problems(campaign);
  const double of_a_run = seconds_of_a_run();
  Forecast forecast{seconds_of_search(campaign, of_problem), 0,
                    seconds_of_report(campaign, of_problem, of_a_run)};
  forecast.one_core = pages * of_a_run;
  std::vector<SolverTime> of_solver;
  for (const PlannedCell* cell : shortest_cells(campaign, of_problem)) {
    const auto time = time_of_solver(campaign, *cell, seconds_of(*cell, of_problem));
    if (!time) forecast.at_least = true;
    of_solver.push_back(time.value_or(SolverTime{}));
  }
  std::vector<double> runs_of_solver(of_solver.size());
  for (const PlannedCell& cell : campaign.cells()) {
    const auto evaluations = static_cast<double>(cell.budget.evaluations);
    const double runs = static_cast<double>(cell.instances) * cell.seeds;
    runs_of_solver[cell.solver] += runs;
    const double hang = campaign.problems()[cell.problem].longest_run.value_or(0);  // as most do
    forecast.runs +=
        runs * (of_a_run + hang +
                evaluations * (seconds_of(cell, of_problem) + of_solver[cell.solver].evaluation));
  }
  // A process is replaced every second: see old_age in worker.cpp.
  const double processes = 1 + forecast.runs;
  for (std::size_t s = 0; s < of_solver.size(); ++s) {
    forecast.runs += std::min(processes, runs_of_solver[s]) * of_solver[s].start;
  }
  return forecast;
}

}  // namespace ricochet
