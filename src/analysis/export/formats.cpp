#include "src/analysis/export/formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ricochet/evaluator.h"
#include "src/analysis/export/output.h"
#include "src/analysis/outcomes.h"
#include "src/core/names.h"
#include "src/experiment/run_rows.h"
#include "src/experiment/stored_fields.h"
#include "src/report/json.h"
#include "src/report/table.h"

namespace ricochet {

RICOCHET_FIELDS(Verdict, feasible, objective, optimality_gap, solved, evaluations_to_solve,
                seconds_to_solve, returned_optimality_gap, returned_solved);

/// As in the store's table of them.
static const EnumNames<TerminationReason>& names_of(TerminationReason /*reason*/) {
  static const EnumNames<TerminationReason> names = {
      {"none", TerminationReason::none},       {"evaluations", TerminationReason::evaluations},
      {"seconds", TerminationReason::seconds}, {"bad point", TerminationReason::bad_point},
      {"failure", TerminationReason::failure}, {"paused", TerminationReason::paused}};
  return names;
}

}  // namespace ricochet

namespace ricochet::exports {

std::vector<Format> all_formats() {
  return {{"csv", "runs.csv, points.csv, running_times.csv, ratings.csv, ecdf.csv and others",
           write_csv, write_ratings},
          {"json", "runs.jsonl, a line for each run, and campaign.json: every figure", write_json},
          {"latex", "summary.tex, the first entries on a page; table.tex, a longtable of all",
           write_latex, write_latex_summary},
          {"markdown", "table.md, what was solved, at what cost", write_markdown},
          {"iohanalyzer", "for IOHanalyzer, a folder for each algorithm", write_iohanalyzer},
          {"coco", "for COCO's post-processing, a folder for each algorithm", write_coco}};
}

namespace {

constexpr const char* csv_readme =
    R"(The stored runs of a campaign of ricochet, as CSV (RFC 4180, lines end with a line feed, UTF-8).
Numbers are the shortest decimals that read back to the same double, or inf or nan. Missing values
are empty. In texts, control characters are written as \x0a; texts of more than 4000 bytes lose
their middle. No text is one that pandas or R take for a missing value: the perturbation nan is called
missing-value, and others, such as NA, have a ' before them.

runs.csv: one row per run. `number` is the argument of `ricochet replay`; budget_per_variable is the
plan's, evaluations_allowed the budget of the run. values, derivatives, hessians: what the solver
requested; charged: the evaluations that this cost, gradients at their price; seconds: processor
time. feasible, objective, optimality_gap, solved: of the best evaluated point, scored on the true
objective whatever the formulation; returned_...: of the point that the solver returned.
optimality_gap: objective minus the best known value; solved: feasible, and optimality_gap <= the
problem's tolerance. terminations: what the solver said at the end of its starts; failure: what was
thrown.
points.csv: one row for the point that a run (its number) returned, and one for its last improvement,
with the coordinates x1, x2, ...; empty beyond the problem's variables. Archives have no points.
improvements.csv: one row for every point of a run (its number) with a better true value than all
points before it: less violation, or equal violation and a lower objective. violation 0: feasible.
running_times.csv: one row per cell, all runs that differ only in instance and number: success rates and
expected running times, by the best evaluated and by the returned point. Unsolved runs count with all
their evaluations, identical runs count once, intervals are 95 %.
ratings.csv: one row per family and entry, a solver-formulation pair, as in the report, with the family's
largest budget: success rates, number of problems that no run solved, mean rank and P(best), the
probability of the least mean rank on problems like these. ecdf.csv: the ECDF of runtimes of each of
them, the share of pairs of problem and target that were reached within so many evaluations per variable,
with its interval over problems. targets.csv: these targets, optimality gaps. The three are missing where
runs are. The report beside the store has its other tables as CSV, too.
completeness.csv: how many runs were planned, are present and are missing, of all and of each part of the
plan. A run that failed or reached a limit is present.
problems.csv: one row per problem, with the factors of its machine. Runs of two stores can be compared
if the problem's hash is the same.

For Parquet, use DuckDB: COPY 'runs.csv' TO 'runs.parquet'.
)";

/// "tolerance reached (x2); stalled (x1)"
std::string text_of(const std::vector<SolverTermination>& terminations) {
  std::string text;
  for (const RepeatedTermination& exit : repeated(terminations)) {
    text += fmt::format("{}{} (x{})", text.empty() ? "" : "; ", exit.reason, exit.starts);
  }
  return text;
}

/// Calls use(column, cell) for every column of runs.csv.
template <class Use>
void each_cell(const comparison::JudgedRun& run, const Use& use) {
  const RunRecord& record = run.stored.record;
  const auto field = [&](const Field& column, const auto& x) { use(column.key, cell_of(x)); };
  use("number", cell_of(run.stored.number));
  visit_fields(field, run.stored.key);
  use("seed", cell_of(record.seed));
  use("evaluations_allowed", cell_of(record.budget.evaluations));
  use("seconds_allowed", cell_of(record.budget.seconds));
  visit_fields(field, record.ledger);
  use("termination_reason", cell_of(record.termination_reason));
  use("failure", cell_of(record.failure));
  use("terminations", cell_of(text_of(record.terminations)));
  std::optional<double> objective, violation;
  if (record.returned) {
    objective = record.returned->true_values.objective;
    violation = record.returned->true_values.violation;
  }
  visit_fields(
      [&](const Field& column, const auto& x) {
        if (column.key == "returned_optimality_gap") {
          use("returned_objective", cell_of(objective));
          use("returned_violation", cell_of(violation));
        }
        field(column, x);
      },
      run.outcome.verdict);
}

std::vector<Column> columns_of_runs() {
  const StoredRun none{};
  std::vector<Column> columns;
  each_cell({StoredProblem(), none, comparison::Outcome()},
            [&](std::string_view name, const Value&) { columns.push_back({std::string(name)}); });
  return columns;
}

Table problem_table(const CampaignDescription& description) {
  std::set<std::string> factors;
  for (const StoredProblem& problem : description.problems) {
    for (const auto& [name, value] : problem.factors) factors.insert(name);
  }
  Table table{"problems"};
  const StoredProblem none;
  visit_columns(
      [&](const Field& column, const auto&) { table.columns.push_back({std::string(column.key)}); },
      none);
  table.columns.front().name = "problem";
  for (const std::string& factor : factors) table.columns.push_back({factor});
  for (const StoredProblem& problem : description.problems) {
    std::vector<Value> row;
    visit_columns([&](const Field&, const auto& x) { row.push_back(cell_of(x)); }, problem);
    for (const std::string& factor : factors) {
      const auto value = problem.factors.find(factor);
      row.push_back(value == problem.factors.end() ? Value() : cell_of(value->second));
    }
    table.add_row(std::move(row));
  }
  return table;
}

Table completeness_table(const Completeness& completeness) {
  Table table{"completeness", columns_named("part,planned,present,missing")};
  for (const auto& [name, planned, present] : completeness.parts) {
    table.add(name, planned, present, planned - present);
  }
  return table;
}

/// Adds the coordinates of a point to a row, and nothing up to as many columns.
void add_point(TableFile& points, std::int64_t run, const char* point, const Vector& x,
               std::int64_t most) {
  if (x.size() == 0) return;  // of an archive
  std::vector<Value> row = {run, std::string(point)};
  row.insert(row.end(), x.begin(), x.end());
  row.resize(static_cast<std::size_t>(most) + 2);
  points.add_row(std::move(row));
}

}  // namespace

void write_csv(const Store& store, const Completeness& completeness,
               const std::filesystem::path& folder) {
  std::int64_t most = 0;  // variables
  for (const auto& problem : store.description().problems) most = std::max(most, problem.variables);
  std::vector<Column> of_points = columns_named("number,point");
  for (std::int64_t k = 1; k <= most; ++k) of_points.push_back({fmt::format("x{}", k)});
  TableFile runs(folder / "runs.csv", columns_of_runs());
  TableFile points(folder / "points.csv", of_points);
  TableFile improvements(folder / "improvements.csv",
                         columns_named("number,evaluations,seconds,objective,violation"));
  Numbering numbering(store.description());
  RunningTimes times(folder / "running_times.csv");
  const auto write_run = [&](const comparison::JudgedRun& run) {
    std::vector<Value> row;
    each_cell(run, [&](std::string_view, Value cell) { row.push_back(std::move(cell)); });
    runs.add_row(std::move(row));
    const auto& [number, key, record] = run.stored;
    if (record.returned) add_point(points, number, "returned", record.returned->x, most);
    if (!record.trace.empty()) {
      add_point(points, number, "last improvement", record.trace.back().x, most);
    }
    for (const auto& [evaluations, seconds, values, x] : record.trace) {
      improvements.add(number, evaluations, seconds, values.objective, values.violation);
    }
  };
  comparison::each_judged(store, write_run,
                          [&](const comparison::JudgedCell& cell) { times.add(cell, numbering); });
  runs.close();
  improvements.close();
  points.close();
  times.close();
  write_file(folder / "problems.csv", csv_of(problem_table(store.description())));
  Table parts = completeness_table(completeness);
  parts.rows.insert(parts.rows.begin(), {std::string("all"), completeness.planned,
                                         completeness.present, completeness.missing()});
  write_file(folder / "completeness.csv", csv_of(parts));
  write_file(folder / "README.txt", csv_readme + ("\n" + as_sentence(completeness)) + "\n");
}

namespace {

using report::Json;

constexpr const char* json_lines_readme =
    R"(The stored runs of a campaign of ricochet, as JSON (UTF-8).

campaign.json: the plan, the problems with best known value and tolerance, the solvers, the program and
the machine; planned, present and missing: numbers of runs, of all and by part of the plan, and of what
runs are missing. A run that failed or reached a limit is present.
runs.jsonl: one line, an object, for each run. `number` is the argument of `ricochet replay`; the key says
which run it is; seconds are of processor time. The verdict is of the best evaluated point, scored on the
true objective, and of the returned one; optimality gap: objective minus the best known value; solved:
feasible, and optimality gap <= tolerance. Improvements: points that were truly better than all before;
[evaluations, seconds, objective, violation] of each, and x of the last. Numbers keep all their digits;
null: there is none, or it is infinite or NaN, as a time without a limit. The perturbation nan is called
missing-value, since pandas takes nan for a missing value.
)";

/// The data as text; invalid UTF-8 in it is no error.
std::string text_of(const Json& data, int indent = -1) {
  return data.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json list(const Vector& x) {
  return Json(std::vector<double>(x.begin(), x.end()));
}

Json json_of(StoredProblem problem) {
  problem.name = label(problem.name);
  Json data(problem);
  data.erase("findings");
  return data;
}

Json json_of(StoredSolver solver) {
  solver.name = label(solver.name);
  return Json(solver);
}

Json json_of(const CampaignDescription& description) {
  return {{"plan", description.plan},
          {"problems",
           report::list_of(description.problems, [](const auto& each) { return json_of(each); })},
          {"solvers",
           report::list_of(description.solvers, [](const auto& each) { return json_of(each); })},
          {"program", description.program},
          {"made", description.made}};
}

Json json_of(RunKey key) {
  for (std::string* name :
       {&key.cell.problem, &key.cell.formulation, &key.cell.perturbation, &key.cell.solver}) {
    *name = label(*name);
  }
  return Json(key);
}

Json json_of(const comparison::JudgedRun& run) {
  const RunRecord& record = run.stored.record;
  Json data = {{"number", run.stored.number},
               {"key", json_of(run.stored.key)},
               {"seed", record.seed},
               {"evaluations_allowed", record.budget.evaluations},
               {"seconds_allowed", record.budget.seconds},
               {"ledger", record.ledger},
               {"termination_reason",
                name_of(names_of(record.termination_reason), record.termination_reason)},
               {"failure", record.failure},
               {"terminations",
                report::list_of(repeated(record.terminations),
                                [](const RepeatedTermination& exit) {
                                  return Json{{"reason", exit.reason}, {"starts", exit.starts}};
                                })},
               {"verdict", run.outcome.verdict}};
  data["returned"] = nullptr;
  if (const auto& returned = record.returned) {
    data["returned"] = {{"objective", returned->true_values.objective},
                        {"violation", returned->true_values.violation},
                        {"x", list(returned->x)}};
  }
  data["improvements"] = report::list_of(record.trace, [](const Improvement& step) {
    return Json::array(
        {step.evaluations, step.seconds, step.true_values.objective, step.true_values.violation});
  });
  data["last_improvement_x"] = record.trace.empty() ? Json() : list(record.trace.back().x);
  return data;
}

}  // namespace

Json json_of(const Completeness& completeness) {
  return {{"planned", completeness.planned},
          {"present", completeness.present},
          {"missing", completeness.missing()},
          {"parts", json_rows_of(completeness_table(completeness))},
          {"missing_shards", completeness.missing_shards},
          {"missing_problems", completeness.missing_problems},
          {"missing_solvers", completeness.missing_solvers},
          {"missing_instances", completeness.missing_instances},
          {"unknown_solvers", completeness.unknown_solvers}};
}

void write_json(const Store& store, const Completeness& completeness,
                const std::filesystem::path& folder) {
  Json campaign = json_of(store.description());
  campaign.update(json_of(completeness));
  write_file(folder / "campaign.json", text_of(campaign, 1));
  OutputFile runs(folder / "runs.jsonl");
  comparison::each_judged(
      store, [&](const comparison::JudgedRun& run) { runs.write(text_of(json_of(run))); },
      [](const comparison::JudgedCell&) {});
  runs.close();
  write_file(folder / "README.txt", json_lines_readme + ("\n" + as_sentence(completeness)) + "\n");
}

}  // namespace ricochet::exports
