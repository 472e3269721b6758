#include "src/app/problem_choice.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "embedded/problem_template.h"
#include "ricochet/error.h"
#include "ricochet/solver.h"
#include "src/app/campaign.h"
#include "src/app/command_line.h"
#include "src/core/progress.h"
#include "src/report/text.h"
#include "src/studies/suite/suite.h"

namespace ricochet::cli {

namespace {

using own::FileConstraint;
using own::FileVariable;
using own::Given;
using own::OwnProblem;
using own::ProblemFile;
using report::counted;
using report::Json;

constexpr std::int64_t shown_failures = 5;
/// A constraint that is so near its limit, compared with constraint_tolerance, is active.
constexpr double near = 100;

OwnProblem opened(const std::string& path, bool allowed, const std::string& run) {
  ProblemFile file = own::read_problem_file(path);
  const own::FileProgram& p = file.program;
  if (!p.told) announce_programs({p.command + p.executable + p.library}, allowed, path);
  OwnProblem own(std::move(file), run);
  if (own.store().forget_if_all_failed() > 0) {
    Progress::announce(own.store_path().string() +
                       ": every evaluation had failed: they are made again");
  }
  own.store().close();
  return own;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// The sample standard deviation; 0 for fewer than two values.
double deviation_of(const std::vector<double>& values) {
  if (values.size() < 2) return 0;
  const double mean = mean_of(values);
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

}  // namespace

void add_problem_choice(CLI::App* command, ProblemChoice& choice) {
  add_value(command, "problem", choice.name,
            "A name of `ricochet list problems`, or a problem file (TOML)", "PROBLEM")
      ->required();
  add_scene_file(command, choice.scene_file, choice.settings);
  add_allowance(command, choice.allow_programs);
}

ChosenProblem choose_problem(const ProblemChoice& choice, const std::string& run) {
  if (own::is_problem_file(choice.name)) {
    if (!choice.scene_file.empty() || !choice.settings.empty()) {
      throw InputError(choice.name + ": is a problem file: leave out --scene and --set");
    }
    OwnProblem own = opened(choice.name, choice.allow_programs, run);
    return {own.problem(), own};
  }
  return {
      named(
          every_problem(suite_families(choice.scene_file, choice.settings)), choice.name, "problem",
          [](const Problem& problem) { return problem.name; }, "`ricochet list problems`"),
      std::nullopt};
}

void check_budget(std::int64_t budget) {
  // A number beyond the range of an integer arrives here as the largest one.
  constexpr std::int64_t largest = 1'000'000'000;
  if (budget < 1 || budget > largest) {
    throw InputError(fmt::format("--budget {}: must be within 1..{}", budget, largest));
  }
}

void check_seed(int seed) {
  if (seed < 0) throw InputError(fmt::format("--seed {}: must be >= 0", seed));
}

Formulation accepted_formulation(const Problem& problem, const Solver& solver,
                                 const std::string& wanted) {
  std::vector<Formulation> accepted;
  std::vector<std::string> names;
  for (const Formulation& formulation : problem.formulations()) {
    if (!solver.accepts(problem.formulated(formulation))) continue;
    accepted.push_back(formulation);
    names.push_back(problem.name_of(formulation));
  }
  if (accepted.empty()) {
    const Capabilities& can = solver.capabilities;
    throw InputError(fmt::format(
        "{} accepts no formulation of {}; variables: {}; constraints: {}; needs: {}", solver.name,
        problem.name, can.variables_in_words(), can.constraints_in_words(), can.needs_in_words()));
  }
  if (wanted.empty()) return accepted.front();
  return named(accepted, wanted,
               fmt::format("formulation of {} that {} accepts", problem.name, solver.name),
               [&](const Formulation& formulation) { return problem.name_of(formulation); });
}

OwnAnswer answer_at(const OwnProblem& own, const Vector& seen, double objective,
                    std::int64_t most) {
  const ProblemFile& file = own.file();
  const Vector x = file.stated(seen);
  OwnAnswer answer;
  answer.objective = objective;
  for (std::size_t i = 0; i < file.variables.size(); ++i) {
    const FileVariable& v = file.variables[i];
    const double value = x[static_cast<Eigen::Index>(i)];
    const double close = 1e-6 * (v.upper - v.lower);
    const char* bound = value <= v.lower + close   ? "lower"
                        : value >= v.upper - close ? "upper"
                                                   : "";
    answer.point.push_back({v.name, v.unit, value, bound});
  }
  const Values values = own.problem().evaluate(seen);
  const std::vector<std::size_t> order = file.order();
  answer.constraints.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const FileConstraint& c = file.constraints[order[i]];
    const double value = values.constraints[static_cast<Eigen::Index>(i)];
    const bool equality = c.kind == own::ConstraintKind::equality;
    answer.constraints[order[i]] = {
        c.name, value, violation_of(value, equality) <= 0,
        c.kind != own::ConstraintKind::binary && std::abs(value) <= near * constraint_tolerance};
  }
  if (!file.noise || file.program.told) return answer;
  // Not the run's own evaluations of the point, of which it has the best: that would flatter it.
  const OwnProblem again(file, "repetitions");
  std::vector<double> objectives;
  const auto standard_error = [&objectives] {
    return deviation_of(objectives) / std::sqrt(static_cast<double>(objectives.size()));
  };
  while (answer.repetitions < most &&
         (objectives.size() < 4 || standard_error() > file.tolerance)) {
    const double minimised = again.problem().evaluate(seen).objective;
    ++answer.repetitions;
    if (std::isfinite(minimised)) {
      objectives.push_back(again.problem().maximises ? 0 - minimised : minimised);
    }
  }
  if (objectives.empty()) return answer;
  answer.mean = mean_of(objectives);
  answer.standard_error = standard_error();
  return answer;
}

std::string in_words(const OwnProblem& own, const OwnAnswer& answer) {
  const auto with_unit = [](double value, const std::string& unit) {
    return fmt::format("{:.9g}{}{}", value, unit.empty() ? "" : " ", unit);
  };
  std::string text;
  for (const OwnAnswer::Coordinate& each : answer.point) {
    text += fmt::format("  {} = {}{}\n", each.name, with_unit(each.value, each.unit),
                        *each.bound == 0 ? "" : fmt::format(", its {} bound", each.bound));
  }
  for (const OwnAnswer::Constraint& each : answer.constraints) {
    text += fmt::format("  {}: {:.3g}, {}\n", each.name, each.value,
                        !each.holds   ? "does not hold"
                        : each.active ? "holds, and is active"
                                      : "holds");
  }
  if (answer.mean) {
    text += fmt::format(
        "The values are noisy. At this point, evaluated {} more, the mean is {} +- {:.2g} "
        "(standard "
        "error).\n",
        counted(answer.repetitions, "time"), with_unit(*answer.mean, own.file().unit),
        *answer.standard_error);
  }
  return text;
}

std::string evaluations_in_words(const OwnProblem& own, const own::EvaluationCounts& counts) {
  std::string text = fmt::format("{} by {}", counted(counts.computed, "evaluation"), own.command());
  if (counts.found > 0) {
    text += fmt::format(", {} from {}", counts.found, own.store_path().string());
  }
  if (counts.failed == 0) return text + ".\n";
  text += fmt::format("; {} failed. Failures so far:\n", counts.failed);
  std::int64_t left = 0, number = 0;
  for (const own::FailureCount& each : own.store().failures()) {
    if (++number > shown_failures) {
      left += each.evaluations;
    } else {
      text += fmt::format("  {} times: {}\n", each.evaluations, one_line(each.reason));
    }
  }
  if (left > 0) text += fmt::format("  {} times: for other reasons\n", left);
  return text;
}

Json json_of(const OwnProblem& own, const own::EvaluationCounts& counts,
             const std::optional<OwnAnswer>& answer) {
  Json json = {{"evaluations_by_program", counts.computed},
               {"evaluations_from_store", counts.found},
               {"failed_evaluations", counts.failed},
               {"failures", report::list_of(own.store().failures(), [](const auto& each) {
                  return Json{{"reason", one_line(each.reason)}, {"evaluations", each.evaluations}};
                })}};
  if (!answer) return json;
  json["best"] = {{"objective", answer->objective},
                  {"variables", report::list_of(answer->point,
                                                [](const auto& each) {
                                                  return Json{{"name", each.name},
                                                              {"unit", each.unit},
                                                              {"value", each.value},
                                                              {"bound", each.bound}};
                                                })},
                  {"constraints", report::list_of(answer->constraints,
                                                  [](const auto& each) {
                                                    return Json{{"name", each.name},
                                                                {"value", each.value},
                                                                {"holds", each.holds},
                                                                {"active", each.active}};
                                                  })},
                  {"mean", answer->mean},
                  {"standard_error", answer->standard_error},
                  {"repetitions", answer->repetitions}};
  return json;
}

namespace {

struct CheckOptions {
  std::string file;
  bool allow_programs = false;
  bool json = false;
};

/// What evaluating the start says.
struct Trial {
  std::vector<Given> given;                 ///< the start, three times
  std::optional<double> slope, difference;  ///< along a line; by the gradient, and by differences
};

constexpr int trials = 3;

/// The slope along a line through the start, where the gradient and the values can be compared.
void compare_slopes(const OwnProblem& own, Trial& trial) {
  const Problem& problem = own.problem();
  if (!problem.differentiate || !trial.given.front().failure.empty()) return;
  const Vector width = problem.upper - problem.lower;
  Vector line = width * 1e-5;
  for (Eigen::Index i = 0; i < line.size(); ++i) {
    if (i % 2 == 1) line[i] *= -1;  // no line of symmetry
    if (problem.start[i] + line[i] > problem.upper[i] ||
        problem.start[i] - line[i] < problem.lower[i])
      line[i] = 0;
  }
  const Derivatives at = problem.differentiate(problem.start);
  trial.slope = at.gradient.dot(line);
  trial.difference = (problem.evaluate(problem.start + line).objective -
                      problem.evaluate(problem.start - line).objective) /
                     2;
}

/// The names of the solvers that can run on it, as it is or penalised.
std::vector<std::string> fitting_solvers(const Problem& problem) {
  std::vector<std::string> names;
  for (const Solver& solver : all_solvers()) {
    const auto formulations = problem.formulations();
    const bool fits = std::any_of(
        formulations.begin(), formulations.end(),
        [&](const Formulation& each) { return solver.accepts(problem.formulated(each)); });
    if (fits) names.push_back(solver.name);
  }
  return names;
}

int check_problem(const CheckOptions& options) {
  const OwnProblem own = opened(options.file, options.allow_programs, "check");
  const ProblemFile& file = own.file();
  if (file.program.told) {
    throw InputError(options.file + ": its values are told, and nothing is there to be checked");
  }
  const Vector start = file.stated(own.problem().start);
  Trial trial;
  for (int k = 0; k < trials; ++k) trial.given.push_back(own.evaluate_again(start));
  compare_slopes(own, trial);
  std::vector<double> seconds, objectives;
  std::string failure;
  for (const Given& each : trial.given) {
    seconds.push_back(each.seconds);
    if (std::isfinite(each.objective)) objectives.push_back(each.objective);
    if (failure.empty()) failure = each.failure;
  }
  std::sort(seconds.begin() + 1, seconds.end());
  const double usual = seconds[1];  // the first one starts the program
  const auto same = [&](const Given& each) {
    return own::bytes_of(each) == own::bytes_of(trial.given.front());
  };
  const bool noisy = failure.empty() && !std::all_of(trial.given.begin(), trial.given.end(), same);
  const std::vector<std::string> fitting = fitting_solvers(own.problem());
  if (options.json) {
    const Json data = {{"problem", file.name},
                       {"start", Vector(start)},
                       {"objectives", objectives},
                       {"failure", failure.empty() ? Json() : Json(failure)},
                       {"seconds", usual},
                       {"first_seconds", trial.given.front().seconds},
                       {"noisy", noisy},
                       {"standard_deviation", deviation_of(objectives)},
                       {"slope_by_gradient", trial.slope},
                       {"slope_by_differences", trial.difference},
                       {"solvers", fitting}};
    fmt::print("{}\n", data.dump(2));
    return failure.empty() ? 0 : 1;
  }
  fmt::print("{}\n", own::text_of(file));
  fmt::print("# {} is {}, with {} and {}.\n", file.name,
             file.goal == own::Goal::maximise ? "to be large" : "to be small",
             counted(file.variables.size(), "variable"),
             counted(file.constraints.size(), "constraint"));
  if (!failure.empty()) {
    fmt::print("# At the start it has no values: {}.\n", failure);
    return 1;
  }
  fmt::print("# At the start it is {:.9g}{}{}; an evaluation takes {}, the first {}.\n",
             objectives.empty() ? std::nan("") : objectives.front(), file.unit.empty() ? "" : " ",
             file.unit, report::seconds_text(usual),
             report::seconds_text(trial.given.front().seconds));
  if (noisy) {
    fmt::print("# Evaluated {} times it has different values: standard deviation {:.2g}.{}\n",
               trials, deviation_of(objectives),
               file.noise ? "" : " Write noise = true, or make the program draw the same numbers.");
  } else {
    fmt::print("# Evaluated {} times it has the same values.{}\n", trials,
               file.noise ? " Is noise = true meant?" : "");
  }
  if (trial.slope) {
    fmt::print(
        "# Slope along a line through the start: {:.6g} by the gradient, {:.6g} by differences.\n",
        *trial.slope, *trial.difference);
  }
  fmt::print("# {} of {} solvers can run on it: {}.\n", fitting.size(), all_solvers().size(),
             fmt::join(fitting, ", "));
  return 0;
}

}  // namespace

void add_problem(CommandLine& line) {
  CLI::App* command = line.add("problem", "Describe your own problem: new, check FILE",
                               "  ricochet problem new > mine.toml\n"
                               "  ricochet problem check mine.toml --allow-programs\n"
                               "  ricochet solve nlopt-cobyla mine.toml --allow-programs");
  command->require_subcommand(1);
  CLI::App* fresh = line.add_part(command, "new", "Print a problem file to start from");
  line.on_call(fresh, [] {
    fmt::print("{}", embedded::problem_template);
    return 0;
  });
  CLI::App* check = line.add_part(
      command, "check", "Evaluate the start three times: cost, noise, and which solvers fit");
  const auto options = std::make_shared<CheckOptions>();
  add_value(check, "file", options->file, "A problem file (TOML)", "FILE")->required();
  add_allowance(check, options->allow_programs);
  add_format(check, options->json);
  line.on_call(check, [options] { return check_problem(*options); });
}

}  // namespace ricochet::cli
