#include "src/cli/solve.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "problems/families.h"
#include "solvers/outside/outside.h"
#include "solvers/solvers.h"
#include "src/campaign/runner.h"
#include "src/cli/named.h"
#include "src/core/error.h"
#include "src/core/instance.h"
#include "src/core/seed.h"
#include "src/core/text_file.h"
#include "src/core/verdict.h"
#include "src/features/feature.h"
#include "src/report/gnuplot.h"
#include "src/report/json.h"

namespace ricochet::cli {
namespace {

using report::Json;

Solver solver_of(const std::string& wanted) {
  const std::optional<Solver> brought = outside::outside_solver(wanted);
  if (brought) return *brought;
  return named(all_solvers(), wanted, "solver", [](const Solver& s) { return s.name; });
}

/// The form asked for, or the first that the solver accepts.
Form form_of(const SolveOptions& options, const Question& question, const Solver& solver) {
  std::vector<Form> accepted;
  std::vector<std::string> names;
  for (const Form& form : question.forms()) {
    if (!solver.accepts(question.problem(form))) continue;
    accepted.push_back(form);
    names.push_back(question.name_of(form));
  }
  if (accepted.empty()) {
    throw InputError(fmt::format("{} accepts no form of {}", solver.name, question.name()));
  }
  if (options.form.empty()) return accepted.front();
  return named(accepted, options.form,
               fmt::format("form of {} that {} accepts", question.name(), solver.name),
               [&](const Form& form) { return question.name_of(form); });
}

/// The problem behind the feature asked for. Its draws are those of problem, instance and run, the
/// same for every solver.
Problem featured(const SolveOptions& options, const Problem& problem, const std::string& form) {
  const Feature feature = named(all_features(), options.feature, "feature",
                                [](const Feature& known) { return known.name; });
  if (!feature.applies(problem)) {
    throw InputError(fmt::format("--feature {}: cannot be had of {}, shown {}: {}", feature.name,
                                 problem.name, form, feature.summary));
  }
  return feature.perturbed(problem,
                           seed_of(problem.name, feature.name, problem.instance, options.seed));
}

/// The problem, which says on a terminal whenever a truly better point was evaluated.
Problem watched(const Problem& problem) {
  if (isatty(STDERR_FILENO) == 0) return problem;
  Problem result = problem;
  result.truth = [problem, best = std::optional<Truth>()](const Vector& x) mutable {
    const Truth truth = truth_at(problem, x);
    if (!best || better(truth, *best)) {
      best = truth;
      fmt::print(stderr, "\r\033[Kbest {:.9g}{}", truth.objective,
                 truth.violation > 0 ? ", not feasible" : "");
    }
    return truth;
  };
  return result;
}

std::string trace_of(const RunRecord& record, const Problem& problem) {
  std::string text = "evaluations,seconds,objective,violation";
  for (Eigen::Index i = 0; i < problem.dimension(); ++i) text += fmt::format(",x{}", i + 1);
  text += "\n";
  for (const Improvement& step : record.trace) {
    text += fmt::format("{},{},{},{}", step.evaluations, step.seconds, step.truth.objective,
                        step.truth.violation);
    for (const double x : step.x) text += fmt::format(",{}", x);
    text += "\n";
  }
  return text;
}

std::string picture_of(const RunRecord& record, const Problem& problem, const std::string& title) {
  report::Chart chart;
  chart.name = "trace";
  chart.title = title;
  chart.x = {.label = "evaluations", .scale = report::Scale::logarithmic};
  chart.y.label = "best true objective";
  chart.width = 720;
  report::Series series{"", report::Mark::steps, {}};
  for (const Improvement& step : record.trace) {
    if (step.truth.violation > 0) continue;
    series.samples.push_back({static_cast<double>(step.evaluations), step.truth.objective});
  }
  if (!series.samples.empty()) {
    series.samples.push_back(
        {static_cast<double>(record.ledger.charged), *series.samples.back().value});
  }
  chart.series = {series};
  if (problem.best_known) {
    chart.lines = {{report::Direction::horizontal, *problem.best_known, "best known"}};
  }
  return report::to_svg(chart);
}

Json json_of(const RunRecord& record, const Verdict& verdict, const std::string& form,
             const std::string& feature, const Problem& problem) {
  Json exits = Json::array();
  for (const SolverExit& exit : record.exits) exits.push_back(exit.reason);
  Json point;
  if (!record.trace.empty()) point = record.trace.back().x;
  return {{"question", record.problem},
          {"solver", record.solver},
          {"form", form},
          {"feature", feature},
          {"instance", record.instance},
          {"run", record.run},
          {"budget", record.budget.evaluations},
          {"solved", verdict.solved},
          {"objective", verdict.objective},
          {"best_known", problem.best_known},
          {"gap", verdict.regret},
          {"evaluations_to_solve", verdict.evaluations_to_solve},
          {"handed_over_solved", verdict.handed_over_solved},
          {"handed_over_gap", verdict.handed_over_regret},
          {"evaluations", record.ledger.charged},
          {"seconds", record.ledger.seconds},
          {"point", point},
          {"exits", exits},
          {"failure", record.failure}};
}

void print(const RunRecord& record, const Verdict& verdict, const std::string& form,
           const std::string& feature, const Problem& problem) {
  fmt::print("{} on {}, shown {}{}, instance {}: {}.\n", record.solver, record.problem, form,
             feature == "plain" ? "" : ", " + feature, record.instance,
             verdict.solved
                 ? fmt::format("solved after {} evaluations", *verdict.evaluations_to_solve)
             : verdict.feasible ? "not solved"
                                : "nothing feasible found");
  if (verdict.objective) {
    fmt::print("Found {:.9g}", *verdict.objective);
    if (verdict.regret)
      fmt::print(", {:.3g} from the best known, {:.9g}", *verdict.regret, *problem.best_known);
    fmt::print(".\n");
  }
  if (!record.handed_over) {
    fmt::print("Handed over: nothing.\n");
  } else if (record.handed_over->truth.violation > 0) {
    fmt::print("Handed over: a point that is not feasible.\n");
  } else {
    fmt::print("Handed over {:.9g}.\n", record.handed_over->truth.objective);
  }
  if (!record.trace.empty()) {
    const Vector& x = record.trace.back().x;
    fmt::print("At");
    for (Eigen::Index i = 0; i < std::min<Eigen::Index>(x.size(), 8); ++i)
      fmt::print(" {:.9g}", x[i]);
    fmt::print("{}.\n", x.size() > 8 ? fmt::format(" ... ({} variables)", x.size()) : "");
  }
  fmt::print("{} evaluations, {:.3g} ms of processor time, {} starts:", record.ledger.charged,
             1e3 * record.ledger.seconds, record.exits.size());
  std::map<std::string, int> exits;
  for (const SolverExit& exit : record.exits) ++exits[exit.reason];
  for (const auto& [reason, times] : exits) fmt::print(" {} times \"{}\"", times, reason);
  fmt::print(".\n");
  if (!record.failure.empty()) fmt::print("Failed: {}\n", record.failure);
}

}  // namespace

int solve(const SolveOptions& options) {
  if (options.budget < 1)
    throw InputError(fmt::format("--budget {}: must be >= 1", options.budget));
  if (options.instance < 0) {
    throw InputError(fmt::format("--instance {}: must be >= 0", options.instance));
  }
  if (options.seed < 0) throw InputError(fmt::format("--seed {}: must be >= 0", options.seed));
  check(options.limits);
  const Solver solver = solver_of(options.solver);
  const Question question = named(every_question(all_families()), options.question, "question",
                                  [](const Question& q) { return q.name(); });
  const Form form = form_of(options, question, solver);
  const std::string form_name = question.name_of(form);
  const Problem problem =
      featured(options, instance(question.problem(form), options.instance), form_name);
  const Problem seen = watched(problem);
  const std::string shown = shown_as(form_name, options.feature);
  RunRecord record;
  run_all({{&seen, &solver, {options.budget}, options.seed, shown}}, options.limits,
          [&record](std::size_t, RunRecord made) { record = std::move(made); });
  if (isatty(STDERR_FILENO) == 1) fmt::print(stderr, "\r\033[K");
  const Verdict verdict = judge(record, problem, question.tolerance);
  std::deque<TextDraft> drafts;
  if (!options.trace.empty()) drafts.emplace_back(options.trace, trace_of(record, problem));
  if (!options.plot.empty()) {
    drafts.emplace_back(options.plot,
                        picture_of(record, problem, solver.name + " on " + question.name()));
  }
  for (TextDraft& draft : drafts) draft.commit();
  if (options.json) {
    fmt::print("{}\n", json_of(record, verdict, form_name, options.feature, problem).dump(2));
  } else {
    print(record, verdict, form_name, options.feature, problem);
  }
  return 0;
}

}  // namespace ricochet::cli
