#pragma once

#include "src/analysis/rating.h"
#include "src/experiment/store.h"
#include "tests/support/files.h"

namespace ricochet::exports {

/// Problems of 1, 5, 6 and 12 variables, and names that every format has trouble with.
inline CampaignDescription hard_description() {
  CampaignDescription description;
  description.plan = "name = \"mine\"\n";
  const std::map<std::string, double> factors = {
      {"restitution", 0.1}, {"friction", 0.25}, {"disturbance", 1.0 / 3}};
  description.problems = {{"top-speed C1", "speed", "C1", 1, 1, 0, 0.01, -8.25, factors},
                          {"profile_6", "count", "C4", 6, 0, 0, 0.5, 3, {{"restitution", 0.9}}},
                          {"wide", "classic", "", 12, 2, 1, 1e-6, 0, {}},
                          {"profile/5", "count", "", 5, 0, 0, 0.5, 1e-3, {}}};
  description.solvers = {{"nlopt-cobyla", "NLopt 2.7.1"},
                         {"python3 'my, \"own\"'.py", ""},
                         {"a|b_c%d{e}\\f#g$h&i~j^k--l", "*[3]"}};
  description.program = {{"version", "0.1.0"}};
  return description;
}

/// A run as one may end: usual, failed before anything was charged, with one evaluation only,
/// without a feasible point, or after improvements of one evaluation.
inline RunRecord any_run(const StoredProblem& problem, std::int64_t budget,
                         std::mt19937_64& random) {
  const auto uniform = [&] { return std::uniform_real_distribution<>(0, 1)(random); };
  const auto below = [&](unsigned end) { return static_cast<std::int64_t>(random() % end); };
  RunRecord record;
  record.problem = problem.name;
  record.seed = random();
  record.budget.evaluations = budget * problem.variables;
  const auto kind = below(6);
  record.ledger.charged =
      kind < 2 ? kind : std::max<std::int64_t>(1, record.budget.evaluations - below(3));
  record.ledger.values = record.ledger.charged;
  record.ledger.derivatives = below(4);
  record.ledger.seconds = uniform();
  record.terminations = {{"tolerance reached"}, {"tolerance reached"}, {"said \"enough\""}};
  if (kind == 0 || kind == 2) record.failure = "thrown, with \"quotes\"\nin two lines";
  double objective = problem.best_known + 10, violation = 2, seconds = 0;
  std::int64_t evaluations = 1 + below(3);
  while (evaluations <= record.ledger.charged && random() % 8 != 0) {
    Vector x(problem.variables);
    for (double& coordinate : x) coordinate = uniform();
    if (violation > 0) violation = kind != 3 && random() % 2 == 0 ? 0 : violation / 2;
    if (violation == 0) objective = problem.best_known + (objective - problem.best_known) / 3;
    if (random() % 40 == 0) objective = problem.best_known;  // nothing is better
    seconds += uniform() / 100;
    record.trace.push_back({evaluations, seconds, {objective, violation}, x});
    if (objective == problem.best_known) break;
    evaluations += below(5) + (kind == 4 ? 0 : 1);
  }
  if (!record.trace.empty() && random() % 2 == 0) {
    record.returned = ReturnedPoint{record.trace.back().x, record.trace.back().true_values};
  }
  return record;
}

/// A store of 288 runs: every solver on every problem, plain and noisy, with 2 budgets, on 3
/// instances twice.
class ExportedStore : public TemporaryFolder {
 protected:
  const CampaignDescription description = hard_description();
  Store store = Store::create(made(folder_) / "runs.sqlite", description);
  std::map<RunKey, RunRecord> records;  ///< a store hands them over in the order of their keys
  const fs::path out = made(folder_ / "out");

  void SetUp() override {
    std::mt19937_64 random(7);
    for (const StoredProblem& problem : description.problems) {
      for (const StoredSolver& solver : description.solvers) {
        for (const char* perturbation : {"plain", "noisy"}) {
          for (const std::int64_t budget : {2, 30}) {
            const Cell cell{problem.name, "original", perturbation, solver.name, budget, "n"};
            for (int k = 0; k < 6; ++k)
              add({cell, 1 + k / 2, k % 2}, any_run(problem, budget, random));
          }
        }
      }
    }
  }

  static fs::path made(const fs::path& folder) {
    fs::create_directories(folder);
    return folder;
  }

  void add(const RunKey& key, const RunRecord& record) {
    store.add(key, record);
    records[key] = record;
  }

  /// Four runs of "profile/5", two of which solve it, after 3 and 5 evaluations; the others are
  /// charged 10 each, and one of them fails. So 28 evaluations for two successes; one of these is
  /// returned, after 3 + 30.
  void add_worked_cell(const std::string& formulation) {
    for (int k = 0; k < 4; ++k) {
      RunRecord record;
      record.ledger.charged = 10;
      if (k < 2) record.trace = {{3 + 2 * k, 0.1, {0.001, 0}, Vector::Zero(5)}};
      if (k == 0) record.returned = ReturnedPoint{Vector::Zero(5), {0.001, 0}};
      if (k == 2) record.trace = {{4, 0.1, {2, 0}, Vector::Zero(5)}};
      if (k == 3) record.failure = "thrown";
      add({{"profile/5", formulation, "plain", "nlopt-cobyla", 7, "n"}, k, 0}, record);
    }
  }

  const StoredProblem& problem(const std::string& name) const {
    return *std::ranges::find(description.problems, name, &StoredProblem::name);
  }

  /// Best optimality gap among feasible points up to a number of evaluations, straight from the
  /// record; 1e30 where there is none.
  double optimality_gap_after(const RunKey& key, std::int64_t evaluations) const {
    double best = 1e30;
    for (const Improvement& step : records.at(key).trace) {
      if (step.true_values.violation > 0 || step.evaluations > evaluations) continue;
      best = std::min(best, step.true_values.objective - problem(key.cell.problem).best_known);
    }
    return best;
  }
};

}  // namespace ricochet::exports
