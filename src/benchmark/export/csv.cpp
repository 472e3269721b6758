#include "src/benchmark/export/csv.h"

#include <fmt/format.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "src/benchmark/analysis/judged_runs.h"
#include "src/benchmark/experiment/store/repeated_terminations.h"
#include "src/benchmark/export/csv_row.h"
#include "src/benchmark/export/output_file.h"
#include "src/benchmark/export/termination_name.h"
#include "src/core/one_line.h"

namespace ricochet::exports {
namespace {

struct Column {
  const char* name;
  std::function<std::string(const comparison::JudgedRun&)> value;
};

constexpr const char* csv_readme =
    R"(The stored runs of a campaign of ricochet, as CSV (RFC 4180, lines end with a line feed, UTF-8).
Numbers are the shortest decimals that read back to the same double, or inf or nan. Missing values
are empty. In texts, control characters are written as \x0a; texts of more than 4000 bytes lose
their middle.

runs.csv: one row per run. `number` is the argument of `ricochet replay`; budget_per_variable is the
plan's, evaluations_allowed the budget of the run. values, derivatives, hessians: what the solver
requested; charged: the evaluations that this cost, gradients at their price; seconds: processor
time. feasible, objective, optimality_gap, solved: of the best evaluated point, scored on the true
objective whatever the formulation; returned_...: of the point that the solver returned.
optimality_gap: objective minus the best known value; solved: feasible, and optimality_gap <= the
problem's tolerance. terminations: what the solver said at the end of its starts; failure: what was
thrown. Coordinates of points are separated by blanks.
improvements.csv: one row for every point of a run (its number) with a better true value than all
points before it: less violation, or equal violation and a lower objective. violation 0: feasible.
problems.csv: one row per problem, with the factors of its machine. Runs of two stores can be compared
if the problem's hash is the same.

For Parquet, use DuckDB: COPY 'runs.csv' TO 'runs.parquet'.
)";

std::string yes_or_no(bool value) {
  return value ? "1" : "0";
}

template <class Integer>
std::string whole(const std::optional<Integer>& value) {
  return value ? std::to_string(*value) : "";
}

std::string point(const Vector& x) {
  std::string text;
  for (const double coordinate : x) {
    if (!text.empty()) text += ' ';
    text += number(coordinate);
  }
  return text;
}

std::string terminations(const std::vector<SolverTermination>& terminations) {
  std::string text;
  for (const RepeatedTermination& exit : repeated(terminations)) {
    text += fmt::format("{}{} (x{})", text.empty() ? "" : "; ", exit.reason, exit.starts);
  }
  return one_line(text);
}

std::vector<Column> key_and_cost() {
  using Run = const comparison::JudgedRun&;
  return {
      {"number", [](Run r) { return std::to_string(r.stored.number); }},
      {"problem", [](Run r) { return one_line(r.stored.key.cell.problem); }},
      {"formulation", [](Run r) { return one_line(r.stored.key.cell.formulation); }},
      {"perturbation", [](Run r) { return one_line(r.stored.key.cell.perturbation); }},
      {"solver", [](Run r) { return one_line(r.stored.key.cell.solver); }},
      {"budget_per_variable", [](Run r) { return std::to_string(r.stored.key.cell.budget); }},
      {"gradient_price", [](Run r) { return one_line(r.stored.key.cell.gradient_price); }},
      {"instance", [](Run r) { return std::to_string(r.stored.key.instance); }},
      {"run", [](Run r) { return std::to_string(r.stored.key.run); }},
      {"seed", [](Run r) { return std::to_string(r.stored.record.seed); }},
      {"evaluations_allowed",
       [](Run r) { return std::to_string(r.stored.record.budget.evaluations); }},
      {"seconds_allowed", [](Run r) { return number(r.stored.record.budget.seconds); }},
      {"values", [](Run r) { return std::to_string(r.stored.record.ledger.values); }},
      {"derivatives", [](Run r) { return std::to_string(r.stored.record.ledger.derivatives); }},
      {"hessians", [](Run r) { return std::to_string(r.stored.record.ledger.hessians); }},
      {"charged", [](Run r) { return std::to_string(r.stored.record.ledger.charged); }},
      {"refused", [](Run r) { return std::to_string(r.stored.record.ledger.refused); }},
      {"seconds", [](Run r) { return number(r.stored.record.ledger.seconds); }},
      {"termination_reason",
       [](Run r) { return std::string(name_of(r.stored.record.termination_reason)); }},
      {"failure", [](Run r) { return one_line(r.stored.record.failure); }},
      {"terminations", [](Run r) { return terminations(r.stored.record.terminations); }},
  };
}

std::vector<Column> verdict_and_points() {
  using Run = const comparison::JudgedRun&;
  return {
      {"feasible", [](Run r) { return yes_or_no(r.outcome.verdict.feasible); }},
      {"objective", [](Run r) { return number(r.outcome.verdict.objective); }},
      {"optimality_gap", [](Run r) { return number(r.outcome.verdict.optimality_gap); }},
      {"solved", [](Run r) { return yes_or_no(r.outcome.verdict.solved); }},
      {"evaluations_to_solve", [](Run r) { return whole(r.outcome.verdict.evaluations_to_solve); }},
      {"seconds_to_solve", [](Run r) { return number(r.outcome.verdict.seconds_to_solve); }},
      {"returned_objective",
       [](Run r) {
         const auto& returned = r.stored.record.returned;
         return returned ? number(returned->true_values.objective) : "";
       }},
      {"returned_violation",
       [](Run r) {
         const auto& returned = r.stored.record.returned;
         return returned ? number(returned->true_values.violation) : "";
       }},
      {"returned_optimality_gap",
       [](Run r) { return number(r.outcome.verdict.returned_optimality_gap); }},
      {"returned_solved", [](Run r) { return yes_or_no(r.outcome.verdict.returned_solved); }},
      {"returned_x",
       [](Run r) {
         const auto& returned = r.stored.record.returned;
         return returned ? point(returned->x) : "";
       }},
      {"last_improvement_x",
       [](Run r) {
         const auto& trace = r.stored.record.trace;
         return trace.empty() ? "" : point(trace.back().x);
       }},
  };
}

std::vector<Column> run_columns() {
  std::vector<Column> columns = key_and_cost();
  for (Column& column : verdict_and_points()) columns.push_back(std::move(column));
  return columns;
}

void write_problems(const CampaignDescription& description, const std::filesystem::path& file) {
  std::set<std::string> factors;
  for (const StoredProblem& problem : description.problems) {
    for (const auto& [name, value] : problem.factors) factors.insert(name);
  }
  std::vector<std::string> header = {"problem",   "family",      "machine",
                                     "variables", "constraints", "equalities",
                                     "tolerance", "best_known",  "hash"};
  for (const std::string& factor : factors) header.push_back(one_line(factor));
  std::string text = csv_row(header);
  for (const StoredProblem& problem : description.problems) {
    std::vector<std::string> row = {one_line(problem.name),
                                    one_line(problem.family),
                                    one_line(problem.machine),
                                    std::to_string(problem.variables),
                                    std::to_string(problem.constraints),
                                    std::to_string(problem.equalities),
                                    number(problem.tolerance),
                                    number(problem.best_known),
                                    problem.hash};
    for (const std::string& factor : factors) {
      const auto value = problem.factors.find(factor);
      row.push_back(value == problem.factors.end() ? "" : number(value->second));
    }
    text += csv_row(row);
  }
  write_file(file, text);
}

}  // namespace

void write_csv(const Store& store, const std::filesystem::path& folder) {
  const std::vector<Column> columns = run_columns();
  std::vector<std::string> fields;
  for (const Column& column : columns) fields.emplace_back(column.name);
  OutputFile runs(folder / "runs.csv");
  runs.write(csv_row(fields));
  OutputFile improvements(folder / "improvements.csv");
  improvements.write(csv_row({"number", "evaluations", "seconds", "objective", "violation"}));
  const auto write_run = [&](const comparison::JudgedRun& run) {
    for (std::size_t k = 0; k < columns.size(); ++k) fields[k] = columns[k].value(run);
    runs.write(csv_row(fields));
    for (const Improvement& step : run.stored.record.trace) {
      improvements.write(
          csv_row({std::to_string(run.stored.number), std::to_string(step.evaluations),
                   number(step.seconds), number(step.true_values.objective),
                   number(step.true_values.violation)}));
    }
  };
  comparison::each_judged(store, write_run, [](const comparison::JudgedCell&) {});
  runs.close();
  improvements.close();
  write_problems(store.description(), folder / "problems.csv");
  write_file(folder / "README.txt", csv_readme);
}

}  // namespace ricochet::exports
