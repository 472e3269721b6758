#include "src/benchmark/stress/study.h"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ricochet/verdict.h"
#include "src/benchmark/experiment/campaign/runner.h"
#include "src/benchmark/stress/pathological_problems.h"

namespace ricochet::studies {
namespace {

using stress::PathologicalProblem;

constexpr double tolerance = 1e-6;

/// How a run ended, as one of a few words, and how far it got. Empty if the solver does not take
/// the problem.
struct Ending {
  std::string problem;
  std::optional<std::string> kind = {}, ending = {};
  std::optional<std::size_t> improvements = {};
  std::optional<std::string> reasons = {};  ///< given by the solver or the run
};
RICOCHET_WRITTEN_AS_JSON(Ending, problem, kind, ending, improvements, reasons);

struct SolverRow {
  std::string solver;
  std::vector<Ending> endings;  ///< one for each problem
};
RICOCHET_WRITTEN_AS_JSON(SolverRow, solver, endings);

struct Counts {
  int runs = 0, solved = 0, spent = 0, ended = 0, threw = 0, killed = 0, crashed = 0;
};
RICOCHET_WRITTEN_AS_JSON(Counts, runs, solved, spent, ended, threw, killed, crashed);

struct ProblemRow {
  std::string problem, what;
};
RICOCHET_WRITTEN_AS_JSON(ProblemRow, problem, what);

struct StressData {
  std::vector<ProblemRow> problems;
  Counts counts;
  std::vector<SolverRow> solvers;
};
RICOCHET_WRITTEN_AS_JSON(StressData, problems, counts, solvers);

std::string reasons_of(const RunRecord& record) {
  std::map<std::string, int> reasons;
  for (const SolverTermination& exit : record.terminations) ++reasons[exit.reason];
  std::string text;
  for (const auto& [reason, times] : reasons) {
    text += fmt::format("{}{} times \"{}\"", text.empty() ? "" : ", ", times, reason);
  }
  return record.failure.empty() ? text : record.failure;
}

Ending ending_of(const RunRecord& record, const Problem& problem, Counts& counts) {
  const auto ended = [&](int& count, const char* kind, std::string text) {
    ++counts.runs;
    ++count;
    return Ending{problem.name, kind, std::move(text), record.trace.size(), reasons_of(record)};
  };
  const std::string& failure = record.failure;
  if (failure.starts_with("killed")) return ended(counts.killed, "killed", "killed");
  if (failure.starts_with("crashed") || failure.starts_with("ended the process")) {
    return ended(counts.crashed, "crashed", failure);
  }
  const std::int64_t charged = record.ledger.charged;
  if (!failure.empty()) return ended(counts.threw, "threw", fmt::format("threw at {}", charged));
  const Verdict verdict = judge(record, problem, tolerance);
  if (verdict.solved) {
    return ended(counts.solved, "solved",
                 fmt::format("solved at {}", *verdict.evaluations_to_solve));
  }
  if (record.termination_reason == TerminationReason::evaluations) {
    return ended(counts.spent, "spent", fmt::format("spent {}", charged));
  }
  return ended(counts.ended, "ended", fmt::format("ended at {}", charged));
}

/// One row for each solver, with an entry for each problem.
StressData compute(const std::vector<Solver>& solvers) {
  const std::vector<PathologicalProblem> ills = stress::pathological_problems();
  StressData data;
  std::vector<Ending> none;
  for (const PathologicalProblem& ill : ills) {
    data.problems.push_back({ill.problem.name, ill.what});
    none.push_back({ill.problem.name});
  }
  for (const Solver& solver : solvers) data.solvers.push_back({solver.name, none});
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
      data.solvers[whose[job]].endings[k] = ending_of(record, ills[k].problem, data.counts);
    });
    progress.advance(1);
  }
  return data;
}

}  // namespace

Study stress_study(const std::vector<Solver>& solvers) {
  return {"stress", "", [solvers](bool) { return compute(solvers); }};
}

}  // namespace ricochet::studies
