#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "ricochet/error.h"
#include "ricochet/problem.h"
#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "solvers/outside/outside.h"
#include "src/app/command_line.h"
#include "src/app/problem_choice.h"
#include "src/app/report.h"
#include "src/core/instance.h"
#include "src/core/progress.h"
#include "src/experiment/perturbations.h"
#include "src/experiment/worker.h"
#include "src/report/drawing.h"
#include "src/report/json.h"
#include "src/report/table.h"
#include "src/report/text.h"

namespace ricochet::cli {
namespace {

using report::Json;

struct SolveOptions {
  std::string solver;
  ProblemChoice problem;
  std::string formulation;             ///< its name; empty: the first that the solver accepts
  std::string perturbation = "plain";  ///< disturbs what the solver sees
  std::int64_t budget = 1000;          ///< evaluations
  int instance = 0;                    ///< 0: the original problem
  int seed = 0;                        ///< number of the run
  std::string trace;                   ///< CSV file of the improvements
  std::string plot;                    ///< SVG file of the improvements
  bool json = false;
  Limits limits;
  bool seconds_given = false;
};

Solver solver_of(const std::string& wanted) {
  const std::optional<Solver> brought = outside::outside_solver(wanted);
  if (brought) return *brought;
  return named(
      all_solvers(), wanted, "solver", [](const Solver& s) { return s.name; },
      "`ricochet list solvers`");
}

/// Throws InputError if what stands first is no solver, but what stands second is.
void refuse_swapped(const SolveOptions& options) {
  if (own::is_problem_file(options.problem.name)) return;
  const auto is_solver = [](const std::string& name) {
    const std::vector<Solver> all = all_solvers();
    return outside::is_outside(name) || std::ranges::find(all, name, &Solver::name) != all.end();
  };
  if (is_solver(options.solver) || !is_solver(options.problem.name)) return;
  throw InputError(fmt::format("{0} {1}: the solver comes first: ricochet solve {1} {0}",
                               options.solver, options.problem.name));
}

/// Wraps the problem in the selected perturbation. Its random numbers depend on problem, instance
/// and run, and are the same for every solver.
Problem featured(const SolveOptions& options, const Problem& problem,
                 const std::string& formulation) {
  const Perturbation perturbation = named(all_perturbations(), options.perturbation, "perturbation",
                                          [](const Perturbation& known) { return known.name; });
  if (!perturbation.applies(problem)) {
    throw InputError(fmt::format("--perturbation {}: does not apply to {}, formulation {}: {}",
                                 perturbation.name, problem.name, formulation,
                                 perturbation.summary));
  }
  return perturbation.perturbed(
      problem, seed_of(problem.name, perturbation.name, problem.instance, options.seed));
}

/// The objective as a user says it: what is maximised is not negated.
double as_said(double objective, const Problem& problem) {
  return problem.maximises ? 0 - objective : objective;
}

/// The same as text, with the unit.
std::string in_words(double objective, const Problem& problem) {
  return fmt::format("{:.9g}{}{}", as_said(objective, problem), problem.unit.empty() ? "" : " ",
                     problem.unit);
}

/// Wraps the problem so that it reports on a terminal whenever a better true objective was
/// evaluated.
Problem watched(const Problem& problem) {
  if (!Progress::redraws()) return problem;
  Problem result = problem;
  result.true_values = [problem, best = std::optional<TrueValues>()](const Vector& x) mutable {
    const TrueValues true_values = true_values_at(problem, x);
    if (!best || better(true_values, *best)) {
      best = true_values;
      const char* const but = true_values.violation > 0 ? ", not feasible" : "";
      std::fputs(
          fmt::format("\r\033[Kbest {}{}", in_words(true_values.objective, problem), but).c_str(),
          stderr);
    }
    return true_values;
  };
  return result;
}

/// The points of the problem as it is stated that a run's points are, which lie in the box of its
/// instance, in the coordinates of its perturbation.
class StatedPoints {
 public:
  /// `own` is the problem, if it is of a problem file.
  StatedPoints(const SolveOptions& options, Problem stated, const std::string& formulation,
               std::optional<own::OwnProblem> own)
      : own_(std::move(own)) {
    stated.true_values = [point = point_](const Vector& natural) {
      *point = natural;
      return TrueValues{};
    };
    seen_ = featured(options, instance(stated, options.instance), formulation);
  }

  Vector of(const Vector& x) const {
    const Vector& point = seen_by_program(x);
    return own_ ? own_->file().stated(point) : point;
  }

  /// The same, before logarithmic variables of a problem file are taken back.
  const Vector& seen_by_program(const Vector& x) const {
    true_values_at(seen_, x);
    return *point_;
  }

 private:
  std::shared_ptr<Vector> point_ = std::make_shared<Vector>();
  std::optional<own::OwnProblem> own_;
  Problem seen_;
};

Table trace_of(const RunRecord& record, const Problem& problem, const StatedPoints& stated) {
  Table table{"trace", columns_named("evaluations,seconds,objective,violation")};
  for (Eigen::Index i = 0; i < problem.dimension(); ++i) {
    table.columns.push_back({fmt::format("x{}", i + 1)});
  }
  for (const Improvement& step : record.trace) {
    std::vector<Value> row = {step.evaluations, step.seconds, step.true_values.objective,
                              step.true_values.violation};
    for (const double x : stated.of(step.x)) row.emplace_back(x);
    table.add_row(std::move(row));
  }
  return table;
}

report::Plot plot_of(const RunRecord& record, const Problem& problem, const std::string& title) {
  report::Chart chart;
  chart.name = "trace";
  chart.title = title;
  chart.x = {.label = "evaluations", .scale = report::Scale::logarithmic};
  chart.y.label = "best true objective" + (problem.unit.empty() ? "" : " [" + problem.unit + "]");
  chart.width = 720;
  report::Series series{"", report::Mark::steps, {}};
  for (const Improvement& step : record.trace) {
    if (step.true_values.violation > 0) continue;
    series.samples.push_back(
        {static_cast<double>(step.evaluations), as_said(step.true_values.objective, problem)});
  }
  if (!series.samples.empty()) {
    series.samples.push_back(
        {static_cast<double>(record.ledger.charged), *series.samples.back().value});
  }
  chart.series = {series};
  if (problem.best_known) {
    chart.lines = {
        {report::Direction::horizontal, as_said(*problem.best_known, problem), "best known"}};
  }
  return report::plot_of({chart});
}

Json json_of(const RunRecord& record, const Verdict& verdict, const std::string& formulation,
             const std::string& perturbation, const Problem& problem, const StatedPoints& stated) {
  Json terminations = Json::array();
  for (const SolverTermination& exit : record.terminations) terminations.push_back(exit.reason);
  Json point, stated_point;
  if (!record.trace.empty()) {
    point = record.trace.back().x;
    stated_point = stated.of(record.trace.back().x);
  }
  return {{"problem", record.problem},
          {"solver", record.solver},
          {"formulation", formulation},
          {"perturbation", perturbation},
          {"instance", record.instance},
          {"run", record.run},
          {"budget", record.budget.evaluations},
          {"solved", verdict.solved},
          {"objective", verdict.objective},
          {"best_known", problem.best_known},
          {"gap", verdict.optimality_gap},
          {"evaluations_to_solve", verdict.evaluations_to_solve},
          {"returned_solved", verdict.returned_solved},
          {"returned_gap", verdict.returned_optimality_gap},
          {"evaluations", record.ledger.charged},
          {"seconds", record.ledger.seconds},
          {"point", point},
          {"stated_point", stated_point},
          {"terminations", terminations},
          {"failure", record.failure}};
}

/// The first coordinates of a point.
std::string in_words(const Vector& x) {
  constexpr Eigen::Index most = 8;
  std::string text = fmt::format("{:.9g}", fmt::join(x.head(std::min(x.size(), most)), " "));
  if (x.size() > most) text += fmt::format(" ... ({} variables)", x.size());
  return text;
}

void print(const RunRecord& record, const Verdict& verdict, const std::string& formulation,
           const std::string& perturbation, const Problem& problem, const StatedPoints& stated) {
  fmt::print("{} on {}, formulation {}{}, instance {}: {}.\n", record.solver, record.problem,
             formulation, perturbation == "plain" ? "" : ", " + perturbation, record.instance,
             verdict.solved
                 ? "solved after " + report::counted(*verdict.evaluations_to_solve, "evaluation")
             : !problem.best_known ? "not scored, as no best value is known"
             : verdict.feasible    ? "not solved"
                                   : "nothing feasible found");
  if (verdict.objective) {
    fmt::print("Best evaluated: {}", in_words(*verdict.objective, problem));
    if (verdict.optimality_gap)
      fmt::print(", {:.3g} from the best known, {}", *verdict.optimality_gap,
                 in_words(*problem.best_known, problem));
    fmt::print(".\n");
  }
  if (!record.returned) {
    fmt::print("Returned: nothing.\n");
  } else if (record.returned->true_values.violation > 0) {
    fmt::print("Returned: a point that is not feasible, by {:.3g}.\n",
               record.returned->true_values.violation);
  } else {
    fmt::print("Returned: {}.\n", in_words(record.returned->true_values.objective, problem));
  }
  if (!record.trace.empty()) {
    const Vector& x = record.trace.back().x;
    const Vector point = stated.of(x);
    const double violation = record.trace.back().true_values.violation;
    fmt::print("Best evaluated point{}: {}.\n",
               violation > 0 ? fmt::format(", not feasible by {:.3g}", violation) : "",
               in_words(point));
    if (point != x) fmt::print("In the solver's own box: {}.\n", in_words(x));
  }
  fmt::print("{}, {} of processor time, ", report::counted(record.ledger.charged, "evaluation"),
             report::seconds_text(record.ledger.seconds));
  if (record.terminations.empty()) {
    fmt::print("no start ended");
  } else {
    fmt::print("{}:", report::counted(record.terminations.size(), "start"));
  }
  std::map<std::string, int> terminations;
  for (const SolverTermination& exit : record.terminations) ++terminations[exit.reason];
  for (const auto& [reason, times] : terminations)
    fmt::print(" {} \"{}\"", report::counted(times, "time"), reason);
  fmt::print(".\n");
}

int solve(const SolveOptions& options) {
  check_budget(options.budget);
  if (options.instance < 0) {
    throw InputError(fmt::format("--instance {}: must be >= 0", options.instance));
  }
  check_seed(options.seed);
  check(options.limits);
  refuse_swapped(options);
  const Solver solver = solver_of(options.solver);
  const auto [asked, own] = choose_problem(
      options.problem, fmt::format("{} {} instance {} seed {}", options.solver, options.formulation,
                                   options.instance, options.seed));
  const Formulation formulation = accepted_formulation(asked, solver, options.formulation);
  const std::string formulation_name = asked.name_of(formulation);
  const Problem problem = featured(
      options, instance(asked.formulated(formulation), options.instance), formulation_name);
  const Problem seen = watched(problem);
  const std::string shown = shown_as(formulation_name, options.perturbation);
  RunRecord record;
  Limits limits = options.limits;
  if (own) {  // what is kept survives, and the program has limits of its own
    if (!options.seconds_given) limits.seconds = 1e8;
    limits.megabytes += own->file().program.megabytes;
  }
  Budget budget{options.budget};
  if (own) budget.gradient_price = asked.gradient_cost;
  run_all({{&seen, &solver, budget, options.seed, shown}}, limits,
          [&record](std::size_t, RunRecord made) { record = std::move(made); });
  if (Progress::redraws()) std::fputs("\r\033[K", stderr);
  const StatedPoints stated(options, asked.formulated(formulation), formulation_name, own);
  const Verdict verdict = judge(record, problem, asked.tolerance);
  report::Plot plot;
  if (!options.plot.empty()) plot = plot_of(record, problem, solver.name + " on " + asked.name);
  write_files(
      {{options.trace, csv_of(trace_of(record, problem, stated))}, {options.plot, plot.svg}});
  std::optional<OwnAnswer> answer;
  if (own && !record.trace.empty()) {
    constexpr std::int64_t repetitions = 10;
    const Improvement& best = record.trace.back();
    answer = answer_at(*own, stated.seen_by_program(best.x),
                       as_said(best.true_values.objective, problem),
                       std::max(repetitions, options.budget / repetitions));
  }
  if (options.json) {
    Json data = json_of(record, verdict, formulation_name, options.perturbation, problem, stated);
    if (own) data.update(json_of(*own, own->counts(), answer));
    fmt::print("{}\n", data.dump(2));
  } else {
    print(record, verdict, formulation_name, options.perturbation, problem, stated);
    if (answer) fmt::print("{}", in_words(*own, *answer));
    if (own) fmt::print("{}", evaluations_in_words(*own, own->counts()));
  }
  report::require_none(plot.failures);
  if (!record.failure.empty()) throw std::runtime_error(record.failure);
  if (own && record.trace.empty()) throw std::runtime_error("no evaluation had a value");
  return 0;
}

}  // namespace

void add_solve(CommandLine& line) {
  CLI::App* command =
      line.add("solve", "Run one solver on one problem and score it",
               "  ricochet solve nlopt-cobyla top-speed-C1 --formulation penalised-count\n"
               "  ricochet solve fireworks profile-count-8-C4 --budget 10000 --plot trace.svg\n"
               "  ricochet solve nlopt-slsqp profile-count-8-scene --scene machine.toml\n"
               "  ricochet solve ./mine.so count-C1\n"
               "  ricochet solve 'python3 mine.py' count-C1\n"
               "  ricochet solve nlopt-cobyla mine.toml --allow-programs");
  const auto options = std::make_shared<SolveOptions>();
  add_value(command, "solver", options->solver,
            "A name of `ricochet list solvers`, a shared library or a program", "SOLVER")
      ->required();
  add_problem_choice(command, options->problem);
  command->add_option("--formulation", options->formulation,
                      "Formulation of the problem; default: the first that the solver accepts");
  std::vector<std::string> perturbations;
  for (const Perturbation& known : all_perturbations()) perturbations.push_back(known.name);
  add_value(command, "--perturbation", options->perturbation, "Perturbation of the problem",
            fmt::format("PERTURBATION:{{{}}}", fmt::join(perturbations, ",")));
  add_value(command, "--budget", options->budget, "Evaluations");
  add_value(command, "--instance", options->instance,
            "0: the original problem; 1, 2, ...: moved and reflected");
  add_value(command, "--seed", options->seed, "Number of the run, which gives its random numbers");
  add_value(command, "--trace", options->trace, "CSV file for the improvements", "FILE");
  add_value(command, "--plot", options->plot, "SVG file for a chart of the improvements", "FILE");
  add_limits(command, options->limits);
  add_format(command, options->json);
  const CLI::Option* const seconds = command->get_option("--run-seconds");
  line.on_call(command, [options, seconds] {
    options->seconds_given = seconds->count() > 0;
    return solve(*options);
  });
}

}  // namespace ricochet::cli
