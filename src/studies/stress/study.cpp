#include "src/studies/stress/study.h"

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "src/campaign/runner.h"
#include "src/core/verdict.h"
#include "src/studies/stress/ill_problems.h"

namespace ricochet::studies {
namespace {

using report::Json;
using stress::IllProblem;

constexpr double tolerance = 1e-6;

/// One of few words, and how far it went.
struct Ending {
  std::string kind;
  std::string text;
};

Ending ending_of(const RunRecord& record, const Problem& problem) {
  if (record.failure.starts_with("killed")) return {"killed", "killed"};
  if (record.failure.starts_with("crashed") || record.failure.starts_with("ended the process")) {
    return {"crashed", record.failure};
  }
  if (!record.failure.empty()) {
    return {"threw", fmt::format("threw at {}", record.ledger.charged)};
  }
  const Verdict verdict = judge(record, problem, tolerance);
  if (verdict.solved) return {"solved", fmt::format("solved at {}", *verdict.evaluations_to_solve)};
  if (record.refusal == Refusal::evaluations) {
    return {"spent", fmt::format("spent {}", record.ledger.charged)};
  }
  return {"ended", fmt::format("ended at {}", record.ledger.charged)};
}

std::string reasons_of(const RunRecord& record) {
  std::map<std::string, int> reasons;
  for (const SolverExit& exit : record.exits) ++reasons[exit.reason];
  std::string text;
  for (const auto& [reason, times] : reasons) {
    text += fmt::format("{}{} times \"{}\"", text.empty() ? "" : ", ", times, reason);
  }
  return record.failure.empty() ? text : record.failure;
}

Json row_of(const RunRecord& record, const IllProblem& ill) {
  const Ending ending = ending_of(record, ill.problem);
  return {{"problem", ill.problem.name},
          {"kind", ending.kind},
          {"ending", ending.text},
          {"improvements", record.trace.size()},
          {"reasons", reasons_of(record)}};
}

/// Of a problem that the solver does not take.
Json no_row(const IllProblem& ill) {
  return {{"problem", ill.problem.name},
          {"kind", nullptr},
          {"ending", nullptr},
          {"improvements", nullptr},
          {"reasons", nullptr}};
}

/// A row a solver, with an entry for each problem.
Json compute(const std::vector<Solver>& solvers) {
  const std::vector<IllProblem> ills = stress::ill_problems();
  Json rows = Json::array();
  for (const Solver& solver : solvers) {
    rows.push_back({{"solver", solver.name}, {"endings", Json::array()}});
    rows.back()["endings"] = report::list_of(ills, no_row);
  }
  std::map<std::string, int> kinds;
  Progress progress("solvers under stress", static_cast<double>(ills.size()));
  for (std::size_t k = 0; k < ills.size(); ++k) {
    std::vector<Job> jobs;
    std::vector<std::size_t> whose;
    for (std::size_t s = 0; s < solvers.size(); ++s) {
      if (!solvers[s].accepts(ills[k].problem)) continue;
      jobs.push_back({&ills[k].problem, &solvers[s], ills[k].budget});
      whose.push_back(s);
    }
    run_all(jobs, ills[k].limits, [&](std::size_t job, const RunRecord& record) {
      Json row = row_of(record, ills[k]);
      ++kinds[row["kind"]];
      ++kinds["runs"];
      rows[whose[job]]["endings"][k] = std::move(row);
    });
    progress.advance(1);
  }
  Json problems = report::list_of(ills, [](const IllProblem& ill) -> Json {
    return {{"problem", ill.problem.name}, {"what", ill.what}};
  });
  Json counts;
  for (const char* kind : {"runs", "solved", "spent", "ended", "threw", "killed", "crashed"}) {
    counts[kind] = kinds[kind];
  }
  return {{"problems", std::move(problems)},
          {"counts", std::move(counts)},
          {"solvers", std::move(rows)}};
}

}  // namespace

Study stress_study(const std::vector<Solver>& solvers) {
  return {"stress", "", [solvers](bool) { return compute(solvers); }};
}

}  // namespace ricochet::studies
