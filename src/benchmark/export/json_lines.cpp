#include "src/export/json_lines.h"

#include <string>

#include "src/export/judged_runs.h"
#include "src/export/output_file.h"
#include "src/export/refusal_name.h"
#include "src/report/json.h"
#include "src/store/repeated_exits.h"

namespace ricochet::exports {
namespace {

using report::Json;

constexpr const char* json_lines_readme =
    "What a campaign of ricochet stored, as JSON (UTF-8).\n"
    "\n"
    "campaign.json: the plan, the questions with best known value and tolerance, the solvers, the\n"
    "program and the machine.\n"
    "runs.jsonl: a line for each run, an object. `number` is that of `ricochet replay`; the key\n"
    "says which run it is; seconds are of processor time. The verdict is of the best point that "
    "was\n"
    "evaluated, by its truth, and of the one handed over; regret: objective less the best known "
    "of\n"
    "the question; solved: feasible, and regret <= tolerance. Improvements: points that were "
    "truly\n"
    "better than all before; [evaluations, seconds, objective, violation] of each, and x of the\n"
    "last. Numbers keep all their digits; null: there is none, or it is infinite or no number, as\n"
    "of a time without a limit.\n";

/// Texts that are no UTF-8 do not stop it.
std::string text_of(const Json& data, int indent = -1) {
  return data.dump(indent, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json list(const Vector& x) {
  return Json(std::vector<double>(x.begin(), x.end()));
}

Json json_of(const StoredQuestion& question) {
  return {{"name", question.name},
          {"family", question.family},
          {"machine", question.machine},
          {"variables", question.variables},
          {"constraints", question.constraints},
          {"equalities", question.equalities},
          {"tolerance", question.tolerance},
          {"best_known", question.best_known},
          {"factors", question.factors}};
}

Json json_of(const CampaignDescription& description) {
  return {{"plan", description.plan},
          {"questions", report::list_of(description.questions,
                                        [](const StoredQuestion& q) { return json_of(q); })},
          {"solvers", report::list_of(description.solvers,
                                      [](const StoredSolver& s) {
                                        return Json{{"name", s.name}, {"version", s.version}};
                                      })},
          {"program", description.program},
          {"made", description.made}};
}

Json json_of(const RunKey& key) {
  return {{"question", key.cell.question},
          {"form", key.cell.form},
          {"feature", key.cell.feature},
          {"solver", key.cell.solver},
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
          {"regret", verdict.regret},
          {"solved", verdict.solved},
          {"evaluations_to_solve", verdict.evaluations_to_solve},
          {"seconds_to_solve", verdict.seconds_to_solve},
          {"handed_over_regret", verdict.handed_over_regret},
          {"handed_over_solved", verdict.handed_over_solved}};
}

Json json_of(const JudgedRun& run) {
  const RunRecord& record = run.stored.record;
  Json data = {
      {"number", run.stored.number},
      {"key", json_of(run.stored.key)},
      {"seed", record.seed},
      {"evaluations_allowed", record.budget.evaluations},
      {"seconds_allowed", record.budget.seconds},
      {"ledger", json_of(record.ledger)},
      {"refusal", name_of(record.refusal)},
      {"failure", record.failure},
      {"exits", report::list_of(repeated(record.exits),
                                [](const RepeatedExit& exit) {
                                  return Json{{"reason", exit.reason}, {"starts", exit.starts}};
                                })},
      {"verdict", json_of(run.outcome.verdict)}};
  data["handed_over"] = nullptr;
  if (const auto& handed_over = record.handed_over) {
    data["handed_over"] = {{"objective", handed_over->truth.objective},
                           {"violation", handed_over->truth.violation},
                           {"x", list(handed_over->x)}};
  }
  data["improvements"] = report::list_of(record.trace, [](const Improvement& step) {
    return Json::array(
        {step.evaluations, step.seconds, step.truth.objective, step.truth.violation});
  });
  data["last_improvement_x"] = record.trace.empty() ? Json() : list(record.trace.back().x);
  return data;
}

}  // namespace

void write_json(const Store& store, const std::filesystem::path& folder) {
  write_file(folder / "campaign.json", text_of(json_of(store.description()), 1));
  OutputFile runs(folder / "runs.jsonl");
  each_judged(
      store, [&](const JudgedRun& run) { runs.write(text_of(json_of(run))); },
      [](const JudgedCell&) {});
  runs.close();
  write_file(folder / "README.txt", json_lines_readme);
}

}  // namespace ricochet::exports
