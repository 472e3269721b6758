#include "src/studies/stress/stress.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "ricochet/run.h"
#include "src/experiment/worker.h"

namespace ricochet::studies::stress {

namespace {

constexpr double centre = 0.3;

/// Half the sum of (x_i - 0.3)^2 on [0, 1]^n, with start 0.9 and best value 0 at 0.3, inside the
/// box. `before` is called at every evaluation; its result is added to the objective, the entries
/// of the gradient and the residuals.
Problem bowl(std::string name, Eigen::Index n, std::function<double(const Vector&)> before) {
  Problem problem;
  problem.name = std::move(name);
  problem.source = "the suite's own, to see what solvers do";
  problem.lower = Vector::Zero(n);
  problem.upper = Vector::Ones(n);
  problem.start = Vector::Constant(n, 0.9);
  problem.evaluate = [before](const Vector& x) {
    return Values{before(x) + (x.array() - centre).square().sum() / 2, {}};
  };
  problem.differentiate = [evaluate = problem.evaluate, before](const Vector& x) {
    const double more = before(x);
    Values values = evaluate(x);
    return Derivatives{std::move(values), x.array() - centre + more, Matrix(0, x.size())};
  };
  problem.residuals = [before](const Vector& x) {
    return Residuals{x.array() - centre + before(x), Matrix::Identity(x.size(), x.size())};
  };
  problem.best_known = 0;
  problem.best_point = Vector::Constant(n, centre);
  return problem;
}

double nothing(const Vector&) {
  return 0;
}

/// NaN where the sum is above 1.2, including at the start.
double no_number(const Vector& x) {
  return x.sum() > 1.2 ? std::numeric_limits<double>::quiet_NaN() : 0;
}

double infinite(const Vector& x) {
  return x.sum() > 1.2 ? std::numeric_limits<double>::infinity() : 0;
}

double throws(const Vector& x) {
  if (x.sum() < 0.8) throw std::runtime_error("the model broke");
  return 0;
}

double sleeps(const Vector&) {
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  return 0;
}

Problem plateau() {
  Problem problem = bowl("plateau", 2, nothing);
  problem.evaluate = [](const Vector&) { return Values{7, {}}; };
  problem.differentiate = [](const Vector& x) {
    return Derivatives{{7, {}}, Vector::Zero(x.size()), Matrix(0, x.size())};
  };
  problem.residuals = [](const Vector& x) {
    return Residuals{Vector::Constant(1, std::sqrt(14.0)), Matrix::Zero(1, x.size())};
  };
  problem.best_known.reset();
  problem.best_point.reset();
  return problem;
}

/// Lowest at a discontinuity, beyond which the objective is higher by 1.
Problem cliff() {
  Problem problem = bowl("cliff", 2, nothing);
  const auto value = [](const Vector& x) {
    return x[0] < centre ? 1 + x[1] : x[0] - centre + x[1];
  };
  problem.evaluate = [value](const Vector& x) { return Values{value(x), {}}; };
  problem.differentiate = [value](const Vector& x) {
    return Derivatives{{value(x), {}}, Vector{{x[0] < centre ? 0.0 : 1.0, 1.0}}, Matrix(0, 2)};
  };
  problem.residuals = nullptr;
  problem.best_point = Vector{{centre, 0}};
  return problem;
}

/// Its constraint, 1 + x^2 <= 0, holds nowhere.
Problem infeasible() {
  Problem problem = bowl("infeasible", 2, nothing);
  problem.constraints = 1;
  const auto constraint = [](const Vector& x) {
    return Vector::Constant(1, 1 + x.squaredNorm()).eval();
  };
  problem.evaluate = [evaluate = problem.evaluate, constraint](const Vector& x) {
    return Values{evaluate(x).objective, constraint(x)};
  };
  problem.differentiate = [differentiate = problem.differentiate, constraint](const Vector& x) {
    Derivatives derivatives = differentiate(x);
    derivatives.values.constraints = constraint(x);
    derivatives.jacobian = 2 * x.transpose();
    return derivatives;
  };
  problem.residuals = nullptr;
  problem.best_known.reset();
  problem.best_point.reset();
  return problem;
}

/// The first `fixed` coordinates can only be 0.3.
Problem narrow(std::string name, Eigen::Index fixed) {
  Problem problem = bowl(std::move(name), 2, nothing);
  problem.lower.head(fixed).setConstant(centre);
  problem.upper.head(fixed).setConstant(centre);
  problem.start.head(fixed).setConstant(centre);
  return problem;
}

}  // namespace

std::vector<PathologicalProblem> pathological_problems() {
  return {
      {"no number in a corner", bowl("no-number", 2, no_number)},
      {"infinite in a corner", bowl("infinite", 2, infinite)},
      {"throws near the best point", bowl("throws", 2, throws)},
      {"the same everywhere", plateau()},
      {"a cliff at the best point", cliff()},
      {"no feasible point", infeasible()},
      {"a box of one point", narrow("one-point", 2)},
      {"one coordinate without a choice", narrow("one-choice", 1)},
      {"budget 0", bowl("budget-0", 2, nothing), {0}},
      {"budget 1", bowl("budget-1", 2, nothing), {1}},
      {"an objective that sleeps, killed after 0.5 s",
       bowl("sleeps", 2, sleeps),
       {400},
       {0.5, 500}},
  };
}

}  // namespace ricochet::studies::stress

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
RICOCHET_FIELDS(Ending, problem, kind, ending, improvements, reasons);

struct SolverRow {
  std::string solver;
  std::vector<Ending> endings;  ///< one for each problem
};
RICOCHET_FIELDS(SolverRow, solver, endings);

struct Counts {
  int runs = 0, solved = 0, spent = 0, ended = 0, threw = 0, killed = 0, crashed = 0;
};
RICOCHET_FIELDS(Counts, runs, solved, spent, ended, threw, killed, crashed);

struct ProblemRow {
  std::string problem, what;
};
RICOCHET_FIELDS(ProblemRow, problem, what);

struct StressData {
  std::vector<ProblemRow> problems;
  Counts counts;
  std::vector<SolverRow> solvers;
};
RICOCHET_FIELDS(StressData, problems, counts, solvers);

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
