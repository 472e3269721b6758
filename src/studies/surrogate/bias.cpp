#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "src/analysis/statistics/intervals.h"
#include "src/analysis/statistics/ranking.h"
#include "src/core/instance.h"
#include "src/core/progress.h"
#include "src/experiment/worker.h"
#include "src/studies/surrogate/study.h"

namespace ricochet::studies::surrogate {

namespace {

using namespace carrier_track;
using report::Json;

std::vector<double> over_speeds(const Machine& machine, double smoothing, const BiasPlan& plan) {
  std::vector<double> values(static_cast<std::size_t>(std::lround(fastest_speed / plan.step)));
  tbb::parallel_for(std::size_t{0}, values.size(), [&](std::size_t k) {
    values[k] =
        objective(at_speed(machine.scene, static_cast<double>(k + 1) * plan.step), smoothing);
  });
  return values;
}

/// The last place at which the values are at most `level`.
std::optional<std::size_t> last_quiet(const std::vector<double>& values, double level) {
  for (std::size_t k = values.size(); k-- > 0;) {
    if (values[k] <= level) return k;
  }
  return std::nullopt;
}

Bias bias_at(double smoothing, const std::vector<double>& counts,
             const std::vector<double>& surrogate, const Machine& machine, const BiasPlan& plan) {
  Bias bias{smoothing, 0, rank_correlation(counts, surrogate), 0, {}, {}};
  for (std::size_t k = 0; k < counts.size(); ++k) {
    bias.error += std::abs(surrogate[k] - counts[k]) / static_cast<double>(counts.size());
  }
  const auto lowest = std::min_element(surrogate.begin(), surrogate.end()) - surrogate.begin();
  bias.count_optimality_gap =
      counts[static_cast<std::size_t>(lowest)] - *std::min_element(counts.begin(), counts.end());
  const auto best = last_quiet(counts, machine.quiet_limit);
  const auto found = last_quiet(surrogate, half_level(machine.quiet_limit));
  if (!best || !found) return bias;
  const auto speed = [&](std::size_t k) { return static_cast<double>(k + 1) * plan.step; };
  bias.speed = speed(*found);
  bias.speed_optimality_gap = speed(*best) - speed(*found);
  bias.loud = counts[*found] > machine.quiet_limit;
  return bias;
}

}  // namespace

BiasStudy study_bias(const BiasPlan& plan) {
  BiasStudy study{plan, {}};
  const std::vector<Machine> machines = all_machines();
  Progress progress("surrogate gap", static_cast<double>(machines.size()));
  for (const Machine& machine : machines) {
    const std::vector<double> counts = over_speeds(machine, 0.0, plan);
    CaseBias& row = study.cases.emplace_back();
    row.id = machine.id;
    row.lowest = static_cast<int>(*std::min_element(counts.begin(), counts.end()));
    const auto best = last_quiet(counts, machine.quiet_limit);
    if (best) row.fastest = static_cast<double>(*best + 1) * plan.step;
    for (const double smoothing : plan.smoothings) {
      row.biases.push_back(
          bias_at(smoothing, counts, over_speeds(machine, smoothing, plan), machine, plan));
    }
    progress.advance(1);
  }
  return study;
}

namespace {

Json smoothing_data(const Bias& bias) {
  return {{"smoothing", bias.smoothing},
          {"error", bias.error},
          {"rank_correlation", bias.rank_correlation},
          {"count_optimality_gap", bias.count_optimality_gap},
          {"count_is_lowest", bias.count_optimality_gap <= 0},
          {"speed", bias.speed},
          {"speed_optimality_gap", bias.speed_optimality_gap},
          {"quiet", bias.speed ? Json(!bias.loud) : Json()}};
}

Json case_data(const CaseBias& row) {
  return {{"id", row.id},
          {"lowest", row.lowest},
          {"fastest", row.fastest},
          {"smoothings", report::list_of(row.biases, smoothing_data)}};
}

/// Error of the fastest quiet speed over the cases, at one smoothing parameter.
Json over_cases(const BiasStudy& study, std::size_t smoothing) {
  std::vector<double> wrong;
  int loud = 0;
  for (const CaseBias& row : study.cases) {
    const Bias& bias = row.biases[smoothing];
    wrong.push_back(bias.speed_optimality_gap ? std::abs(*bias.speed_optimality_gap) : 18.0);
    loud += bias.loud ? 1 : 0;
  }
  return {{"smoothing", study.plan.smoothings[smoothing]},
          {"median", quantile(wrong, 0.5)},
          {"worst", *std::max_element(wrong.begin(), wrong.end())},
          {"loud", loud},
          {"cases", study.cases.size()}};
}

}  // namespace

Json data_of(const BiasStudy& study) {
  const std::size_t last = study.plan.smoothings.size() - 1;
  std::size_t usual = 0;
  while (usual < last && study.plan.smoothings[usual] > 0.25) ++usual;
  return {{"usual", over_cases(study, usual)},
          {"narrowest", over_cases(study, last)},
          {"speeds", std::lround(18 / study.plan.step)},
          {"smoothings", study.plan.smoothings.size()},
          {"cases", report::list_of(study.cases, case_data)}};
}

namespace {

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
