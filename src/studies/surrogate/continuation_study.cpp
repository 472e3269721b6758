#include "src/studies/surrogate/continuation_study.h"

#include <algorithm>
#include <deque>
#include <limits>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/questions/top_speed.h"
#include "solvers/solvers.h"
#include "src/campaign/runner.h"
#include "src/core/instance.h"
#include "src/core/verdict.h"

namespace ricochet::studies::surrogate {
namespace {

using namespace carrier_track;

/// Those that want derivatives and take constraints, alone and led.
std::vector<Solver> guided_solvers() {
  std::vector<Solver> solvers;
  for (Solver& solver : all_solvers()) {
    const std::string& name = solver.name;
    if (name == "nlopt-slsqp" || name == "ipopt" || name.rfind("continuation-", 0) == 0) {
      solvers.push_back(std::move(solver));
    }
  }
  return solvers;
}

Guidance guidance_of(const std::string& id, const Problem& problem,
                     const std::vector<RunRecord>& records) {
  Guidance row{id, records.front().solver, records.front().budget.evaluations, 0, 0, {}};
  for (const RunRecord& record : records) {
    const Verdict verdict = judge(record, problem, speed_tolerance);
    row.solved += verdict.solved;
    row.worst_regret = std::max(row.worst_regret,
                                verdict.regret.value_or(std::numeric_limits<double>::infinity()));
    if (!verdict.solved && row.exit.empty() && !record.exits.empty())
      row.exit = record.exits.back();
  }
  return row;
}

}  // namespace

ContinuationStudy study_continuation(const ContinuationPlan& plan) {
  ContinuationStudy study{plan, {}};
  const std::vector<Solver> solvers = guided_solvers();
  struct Entry {
    std::string id;
    Problem problem;
  };
  std::vector<Entry> entries;
  for (const Machine& machine : all_machines()) {
    if (!find_case(machine.id).claim.threshold) continue;
    entries.push_back({machine.id, top_speed_question(machine).problem({default_width})});
  }
  std::deque<Problem> problems;  // stays in place while the jobs point into it
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
      study.rows.push_back(guidance_of(entry.id, entry.problem, {next, next + plan.instances}));
      next += plan.instances;
    }
  }
  return study;
}

}  // namespace ricochet::studies::surrogate
