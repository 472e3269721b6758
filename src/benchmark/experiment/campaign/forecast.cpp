#include "src/benchmark/experiment/campaign/forecast.h"

#include <algorithm>
#include <vector>

#include "ricochet/stopwatch.h"
#include "src/benchmark/experiment/campaign/runner.h"
#include "src/core/progress.h"

namespace ricochet {
namespace {

/// Overhead [s] of processes and of the store for each run.
constexpr double seconds_of_a_run = 1e-3;

/// Mean time [s] of an evaluation at the problem's start.
double seconds_of(const Problem& problem) {
  Stopwatch stopwatch;
  int evaluations = 0;
  do {
    try {
      static_cast<void>(problem.evaluate(problem.start));
    } catch (const std::exception&) {
      // Only the time counts here.
    }
    ++evaluations;
  } while (evaluations < 100 && stopwatch.read() < 1e-3);
  return stopwatch.read() / evaluations;
}

}  // namespace

double foretold_seconds(const Campaign& campaign) {
  const auto& cells = campaign.cells();
  std::vector<double> of_problem;
  {
    Progress progress("timing problems", static_cast<double>(campaign.problems().size()));
    for (const Problem& problem : campaign.problems()) {
      of_problem.push_back(seconds_of(problem));
      progress.advance(1);
    }
  }
  // The cell with the shortest run of every solver.
  std::vector<const PlannedCell*> shortest(campaign.solvers().size());
  for (const PlannedCell& cell : cells) {
    const PlannedCell*& mine = shortest[cell.solver];
    const auto length = [](const PlannedCell& c) { return c.budget.evaluations; };
    if (mine == nullptr || length(cell) < length(*mine)) mine = &cell;
  }
  std::vector<Problem> problems;
  for (const PlannedCell* cell : shortest) {
    problems.push_back(campaign.problems()[cell->problem].formulated(cell->formulation));
  }
  std::vector<Job> jobs;
  for (std::size_t s = 0; s < shortest.size(); ++s) {
    jobs.push_back({&problems[s], &campaign.solvers()[s], shortest[s]->budget});
  }
  std::vector<double> of_solver(jobs.size());
  run_all(jobs, campaign.plan().limits, [&](std::size_t s, const RunRecord& record) {
    const auto evaluations = static_cast<double>(std::max<std::int64_t>(1, record.ledger.charged));
    of_solver[s] =
        std::max(0.0, record.ledger.seconds / evaluations - of_problem[shortest[s]->problem]);
  });
  double seconds = 0;
  for (const PlannedCell& cell : cells) {
    const auto evaluations = static_cast<double>(cell.budget.evaluations);
    const double runs = static_cast<double>(cell.instances) * cell.seeds;
    seconds += runs * (seconds_of_a_run +
                       evaluations * (of_problem[cell.problem] + of_solver[cell.solver]));
  }
  return seconds;
}

}  // namespace ricochet
