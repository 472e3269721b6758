#include "src/benchmark/export/json_lines.h"

#include <string>

#include "src/benchmark/analysis/judged_runs.h"
#include "src/benchmark/experiment/store/repeated_terminations.h"
#include "src/benchmark/export/output_file.h"
#include "src/benchmark/export/termination_name.h"
#include "src/core/label.h"
#include "src/report/json.h"

namespace ricochet::exports {
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

Json json_of(const StoredProblem& problem) {
  return {{"name", label(problem.name)},
          {"family", problem.family},
          {"machine", problem.machine},
          {"variables", problem.variables},
          {"constraints", problem.constraints},
          {"equalities", problem.equalities},
          {"tolerance", problem.tolerance},
          {"best_known", problem.best_known},
          {"hash", problem.hash},
          {"factors", problem.factors}};
}

Json json_of(const CampaignDescription& description) {
  return {
      {"plan", description.plan},
      {"problems",
       report::list_of(description.problems, [](const StoredProblem& q) { return json_of(q); })},
      {"solvers",
       report::list_of(
           description.solvers,
           [](const StoredSolver& s) {
             return Json{{"name", label(s.name)}, {"version", s.version}, {"content", s.content}};
           })},
      {"program", description.program},
      {"made", description.made}};
}

Json json_of(const RunKey& key) {
  return {{"problem", label(key.cell.problem)},
          {"formulation", label(key.cell.formulation)},
          {"perturbation", label(key.cell.perturbation)},
          {"solver", label(key.cell.solver)},
          {"budget_per_variable", key.cell.budget},
          {"gradient_price", key.cell.gradient_price},
          {"instance", key.instance},
          {"run", key.run}};
}

Json json_of(const Ledger& ledger) {
  return {{"values", ledger.values},     {"derivatives", ledger.derivatives},
          {"hessians", ledger.hessians}, {"charged", ledger.charged},
          {"refused", ledger.refused},   {"seconds", ledger.seconds}};
}

Json json_of(const Verdict& verdict) {
  return {{"feasible", verdict.feasible},
          {"objective", verdict.objective},
          {"optimality_gap", verdict.optimality_gap},
          {"solved", verdict.solved},
          {"evaluations_to_solve", verdict.evaluations_to_solve},
          {"seconds_to_solve", verdict.seconds_to_solve},
          {"returned_optimality_gap", verdict.returned_optimality_gap},
          {"returned_solved", verdict.returned_solved}};
}

Json json_of(const comparison::JudgedRun& run) {
  const RunRecord& record = run.stored.record;
  Json data = {{"number", run.stored.number},
               {"key", json_of(run.stored.key)},
               {"seed", record.seed},
               {"evaluations_allowed", record.budget.evaluations},
               {"seconds_allowed", record.budget.seconds},
               {"ledger", json_of(record.ledger)},
               {"termination_reason", name_of(record.termination_reason)},
               {"failure", record.failure},
               {"terminations",
                report::list_of(repeated(record.terminations),
                                [](const RepeatedTermination& exit) {
                                  return Json{{"reason", exit.reason}, {"starts", exit.starts}};
                                })},
               {"verdict", json_of(run.outcome.verdict)}};
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
          {"parts", report::list_of(completeness.parts,
                                    [](const Completeness::Part& part) {
                                      return Json{{"part", part.name},
                                                  {"planned", part.planned},
                                                  {"present", part.present},
                                                  {"missing", part.planned - part.present}};
                                    })},
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
