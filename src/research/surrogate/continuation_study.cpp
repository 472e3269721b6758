#include "src/research/surrogate/continuation_study.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/problems/top_speed.h"
#include "ricochet/solvers.h"
#include "ricochet/verdict.h"
#include "src/benchmark/experiment/campaign/runner.h"
#include "src/core/instance.h"

namespace ricochet::studies::surrogate {
namespace {

using namespace carrier_track;
using report::Json;

/// Solvers with derivatives and constraints, alone and with continuation.
std::vector<Solver> compared_solvers() {
  std::vector<Solver> solvers;
  for (Solver& solver : all_solvers()) {
    const std::string& name = solver.name;
    if (name == "nlopt-slsqp" || name == "ipopt-tuned" || name.rfind("continuation-", 0) == 0) {
      solvers.push_back(std::move(solver));
    }
  }
  return solvers;
}

}  // namespace

ContinuationRuns runs_of(const std::string& id, const Problem& problem,
                         const std::vector<RunRecord>& records) {
  ContinuationRuns runs{id, records.front().solver, records.front().budget.evaluations, 0, 0, {}};
  for (const RunRecord& record : records) {
    const Verdict verdict = judge(record, problem, speed_tolerance);
    runs.solved += verdict.solved;
    runs.worst_optimality_gap =
        std::max(runs.worst_optimality_gap,
                 verdict.optimality_gap.value_or(std::numeric_limits<double>::infinity()));
    if (!verdict.solved && runs.exit.empty() && !record.terminations.empty()) {
      runs.exit = record.terminations.back().reason;
    }
  }
  return runs;
}

ContinuationStudy study_continuation(const ContinuationPlan& plan) {
  ContinuationStudy study{plan, {}};
  const std::vector<Solver> solvers = compared_solvers();
  struct Entry {
    std::string id;
    Problem problem;
  };
  std::vector<Entry> entries;
  for (const Machine& machine : all_machines()) {
    if (!find_case(machine.id).claim.threshold) continue;
    entries.push_back({machine.id, top_speed_problem(machine).formulated({default_smoothing})});
  }
  std::deque<Problem> problems;  // addresses must remain valid: the jobs refer to them
  std::vector<Job> jobs;
  for (const Entry& entry : entries) {
    for (const Solver& solver : solvers) {
      for (const long budget : plan.budgets) {
        for (int i = 1; i <= plan.instances; ++i) {
          problems.push_back(instance(entry.problem, i));
          jobs.push_back({&problems.back(), &solver, Budget{budget}, 0});
        }
      }
    }
  }
  Progress progress("continuation", static_cast<double>(jobs.size()));
  const std::vector<RunRecord> records = run_all(jobs, progress);
  auto next = records.begin();
  for (const Entry& entry : entries) {
    for (std::size_t k = 0; k < solvers.size() * plan.budgets.size(); ++k) {
      study.rows.push_back(runs_of(entry.id, entry.problem, {next, next + plan.instances}));
      next += plan.instances;
    }
  }
  return study;
}

Json data_of(const ContinuationStudy& study) {
  const std::vector<ContinuationRuns>& rows = study.rows;
  const auto columns = static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(),
                    [&](const ContinuationRuns& row) { return row.id == rows.front().id; }));
  Json data = {{"tolerance", speed_tolerance},
               {"instances", study.plan.instances},
               {"evaluations", study.plan.budgets.back()},
               {"columns", Json::array()},
               {"longest", Json::array()},
               {"cases", Json::array()},
               {"failures", Json::array()}};
  std::vector<int> solved(columns);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const ContinuationRuns& row = rows[k];
    const int failed = study.plan.instances - row.solved;
    if (k % columns == 0) data["cases"].push_back({{"id", row.id}, {"runs", Json::array()}});
    data["cases"].back()["runs"].push_back(
        {{"solved", row.solved}, {"share", nullptr}, {"all", failed == 0 ? Json(true) : Json()}});
    if (failed > 0 && row.solver.starts_with("continuation-")) {
      data["failures"].push_back(
          {{"id", row.id},
           {"solver", row.solver},
           {"budget", row.budget},
           {"failed", failed},
           {"worst",
            std::isfinite(row.worst_optimality_gap) ? Json(row.worst_optimality_gap) : Json()},
           {"exit", row.exit}});
    }
    solved[k % columns] += row.solved;
  }
  const double runs = static_cast<double>(rows.size() / columns) * study.plan.instances;
  Json all = {{"id", "all"}, {"runs", Json::array()}};
  for (std::size_t k = 0; k < columns; ++k) {
    const double share = solved[k] / runs;
    const Json column = {{"solver", rows[k].solver}, {"budget", rows[k].budget}, {"share", share}};
    data["columns"].push_back(column);
    if (rows[k].budget == study.plan.budgets.back()) data["longest"].push_back(column);
    all["runs"].push_back({{"solved", solved[k]}, {"share", share}, {"all", nullptr}});
  }
  data["cases"].push_back(std::move(all));
  return data;
}

}  // namespace ricochet::studies::surrogate
