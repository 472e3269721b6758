#include "src/export/csv.h"

#include <fmt/format.h>

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "src/core/one_line.h"
#include "src/export/csv_row.h"
#include "src/export/judged_runs.h"
#include "src/export/output_file.h"
#include "src/export/refusal_name.h"
#include "src/store/repeated_exits.h"

namespace ricochet::exports {
namespace {

struct Column {
  const char* name;
  std::function<std::string(const JudgedRun&)> value;
};

constexpr const char* csv_readme =
    "What a campaign of ricochet stored, as CSV (RFC 4180, lines end with a line feed, UTF-8).\n"
    "Numbers are the shortest decimals that read back to the same double; inf and nan are such.\n"
    "What is missing is empty. In texts control characters are written as \\x0a, and of more than\n"
    "4000 bytes the middle is left out.\n"
    "\n"
    "runs.csv: a row a run. `number` is that of `ricochet replay`; budget_per_variable is the\n"
    "plan's, evaluations_allowed what it came to. values, derivatives, hessians: what was asked "
    "of\n"
    "the problem; charged: evaluations that this cost, gradients at their price; seconds are of\n"
    "processor time. feasible, objective, regret, solved: of the best point that was evaluated, "
    "by\n"
    "its truth, whatever the solver was shown; the handed_over ones: of what it returned. regret:\n"
    "objective less the best known of the question; solved: feasible, and regret <= tolerance.\n"
    "exits: what the solver said at the end of its starts; failure: what was thrown. Points have\n"
    "a blank between their coordinates.\n"
    "improvements.csv: a row for every point of a run (its number) that was truly better than all\n"
    "before it; less violation is better, then less objective. violation 0: feasible.\n"
    "questions.csv: a row a question; beside what all have, the factors of their machines.\n"
    "\n"
    "There is no Parquet here; DuckDB makes it: COPY 'runs.csv' TO 'runs.parquet'.\n";

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

std::string exits(const std::vector<SolverExit>& exits) {
  std::string text;
  for (const RepeatedExit& exit : repeated(exits)) {
    text += fmt::format("{}{} (x{})", text.empty() ? "" : "; ", exit.reason, exit.starts);
  }
  return one_line(text);
}

std::vector<Column> key_and_cost() {
  using Run = const JudgedRun&;
  return {
      {"number", [](Run r) { return std::to_string(r.stored.number); }},
      {"question", [](Run r) { return one_line(r.stored.key.cell.question); }},
      {"form", [](Run r) { return one_line(r.stored.key.cell.form); }},
      {"feature", [](Run r) { return one_line(r.stored.key.cell.feature); }},
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
      {"refusal", [](Run r) { return std::string(name_of(r.stored.record.refusal)); }},
      {"failure", [](Run r) { return one_line(r.stored.record.failure); }},
      {"exits", [](Run r) { return exits(r.stored.record.exits); }},
  };
}

std::vector<Column> verdict_and_points() {
  using Run = const JudgedRun&;
  return {
      {"feasible", [](Run r) { return yes_or_no(r.outcome.verdict.feasible); }},
      {"objective", [](Run r) { return number(r.outcome.verdict.objective); }},
      {"regret", [](Run r) { return number(r.outcome.verdict.regret); }},
      {"solved", [](Run r) { return yes_or_no(r.outcome.verdict.solved); }},
      {"evaluations_to_solve", [](Run r) { return whole(r.outcome.verdict.evaluations_to_solve); }},
      {"seconds_to_solve", [](Run r) { return number(r.outcome.verdict.seconds_to_solve); }},
      {"handed_over_objective",
       [](Run r) {
         const auto& handed_over = r.stored.record.handed_over;
         return handed_over ? number(handed_over->truth.objective) : "";
       }},
      {"handed_over_violation",
       [](Run r) {
         const auto& handed_over = r.stored.record.handed_over;
         return handed_over ? number(handed_over->truth.violation) : "";
       }},
      {"handed_over_regret", [](Run r) { return number(r.outcome.verdict.handed_over_regret); }},
      {"handed_over_solved", [](Run r) { return yes_or_no(r.outcome.verdict.handed_over_solved); }},
      {"handed_over_x",
       [](Run r) {
         const auto& handed_over = r.stored.record.handed_over;
         return handed_over ? point(handed_over->x) : "";
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

void write_questions(const CampaignDescription& description, const std::filesystem::path& file) {
  std::set<std::string> factors;
  for (const StoredQuestion& question : description.questions) {
    for (const auto& [name, value] : question.factors) factors.insert(name);
  }
  std::vector<std::string> header = {"question",    "family",     "machine",   "variables",
                                     "constraints", "equalities", "tolerance", "best_known"};
  for (const std::string& factor : factors) header.push_back(one_line(factor));
  std::string text = csv_row(header);
  for (const StoredQuestion& question : description.questions) {
    std::vector<std::string> row = {one_line(question.name),
                                    one_line(question.family),
                                    one_line(question.machine),
                                    std::to_string(question.variables),
                                    std::to_string(question.constraints),
                                    std::to_string(question.equalities),
                                    number(question.tolerance),
                                    number(question.best_known)};
    for (const std::string& factor : factors) {
      const auto value = question.factors.find(factor);
      row.push_back(value == question.factors.end() ? "" : number(value->second));
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
  const auto write_run = [&](const JudgedRun& run) {
    for (std::size_t k = 0; k < columns.size(); ++k) fields[k] = columns[k].value(run);
    runs.write(csv_row(fields));
    for (const Improvement& step : run.stored.record.trace) {
      improvements.write(csv_row({std::to_string(run.stored.number),
                                  std::to_string(step.evaluations), number(step.seconds),
                                  number(step.truth.objective), number(step.truth.violation)}));
    }
  };
  each_judged(store, write_run, [](const JudgedCell&) {});
  runs.close();
  improvements.close();
  write_questions(store.description(), folder / "questions.csv");
  write_file(folder / "README.txt", csv_readme);
}

}  // namespace ricochet::exports
