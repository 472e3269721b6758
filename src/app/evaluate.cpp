#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "ricochet/error.h"
#include "ricochet/evaluator.h"
#include "ricochet/problem.h"
#include "solvers/outside/line_solver.h"
#include "solvers/outside/outside.h"
#include "src/app/command_line.h"
#include "src/app/problem_choice.h"
#include "src/core/instance.h"
#include "src/core/names.h"
#include "src/report/json.h"

namespace ricochet::cli {

/// The values at a point.
struct Answer {
  Derivatives told;        ///< only the values if no derivatives were requested
  Residuals residuals;     ///< if requested; with their Jacobian only if derivatives were requested
  TrueValues true_values;  ///< the suite scores by these

  /// Returns all its numbers as one list.
  std::vector<double> numbers() const;
};

/// Has keys for derivatives and residuals if they were requested. JSON has no infinity and no NaN:
/// these are null.
report::Json json_of(const Answer& answer, outside::Wanted wanted);

/// A run of an external optimiser, which ends when the optimiser decides so.
class OutsideRun {
 public:
  explicit OutsideRun(Problem problem);
  OutsideRun(const OutsideRun&) = delete;
  OutsideRun& operator=(const OutsideRun&) = delete;

  const Problem& problem() const { return problem_; }

  /// Throws what the problem throws; the run continues.
  Answer answer(const Vector& x, outside::Wanted wanted);

  /// The number of evaluations that a solver would have been charged.
  std::int64_t evaluations() { return before_ + evaluator_->ledger().charged; }

 private:
  Problem problem_;
  std::int64_t before_ = 0;             // evaluations until the problem last threw
  std::optional<Evaluator> evaluator_;  // renewed after that
};

namespace {

using outside::longest_line;
using report::Json;

struct EvaluateOptions {
  ProblemChoice problem;
  std::string formulation;   ///< its name; empty: original
  int instance = 0;          ///< 0: the original problem
  bool derivatives = false;  ///< return them, too, unless a line says otherwise
  bool replay = false;       ///< evaluate every point twice, and compare
  bool describe = false;     ///< describe the problem and evaluate nothing
};

Json description_of(const Problem& asked, const Formulation& formulation, const Problem& problem) {
  return {
      {"problem", asked.name},
      {"source", problem.source},
      {"cluster", asked.cluster.empty() ? asked.name : asked.cluster},
      {"formulation", asked.name_of(formulation)},
      {"formulations",
       report::list_of(asked.formulations(),
                       [&](const Formulation& each) { return asked.name_of(each); })},
      {"instance", problem.instance},
      {"dimension", problem.dimension()},
      {"constraints", problem.constraints},
      {"equalities", problem.equalities},
      {"derivatives", static_cast<bool>(problem.differentiate)},
      {"residuals", static_cast<bool>(problem.residuals)},
      {"variables", report::list_of(problem.variables,
                                    [](const Variable& variable) {
                                      return Json{{"name", variable.name}, {"unit", variable.unit}};
                                    })},
      {"lower", problem.lower},
      {"upper", problem.upper},
      {"start", problem.start},
      {"best_known", problem.best_known},
      {"best_point", problem.best_point ? Json(*problem.best_point) : Json()},
      {"provenance", asked.provenance},
      {"proven", asked.best_known && asked.not_excluded
                     ? Json(asked.not_excluded(*asked.best_known).empty())
                     : Json()},
      {"penalty_weight", asked.constraints > 0 ? Json(asked.penalty_weight) : Json()},
      {"tolerance", asked.tolerance}};
}

bool is_blank(char letter) {
  return letter == ' ' || letter == '\t' || letter == '\r';
}

/// Reads the next line of standard input, without its end; of a line that is too long only the
/// beginning and its last letter that is not blank. Returns false at the end of the input.
bool read_line(std::string& line) {
  line.clear();
  int letter = getc_unlocked(stdin);
  if (letter == EOF) return false;
  for (; letter != EOF && letter != '\n'; letter = getc_unlocked(stdin)) {
    if (line.size() <= longest_line) {
      line.push_back(static_cast<char>(letter));
    } else if (!is_blank(static_cast<char>(letter))) {
      line.back() = static_cast<char>(letter);
    }
  }
  return true;
}

Json parsed(const std::string& line) {
  if (line.size() > longest_line) {
    throw InputError(fmt::format("is longer than {} MiB", longest_line >> 20));
  }
  try {
    return Json::parse(line);
  } catch (const Json::parse_error& error) {
    throw InputError(fmt::format("is no JSON, from byte {} on", error.byte));
  } catch (const Json::out_of_range&) {
    throw InputError("has a number that is too large");
  }
}

/// Reads the points of a line: as in the line protocol of solvers, except that they are under "x",
/// or the whole line.
outside::AskedPoints points_of(const std::string& line, const Problem& problem, bool derivatives) {
  Json request = parsed(line);
  if (request.is_array()) request = {{"x", std::move(request)}};
  if (!request.is_object() || !request.contains("x")) {
    throw InputError(
        R"(must be a point, such as [1, 2] or {"x": [1, 2]}, or a list of points, [[1, 2], [3, 4]])");
  }
  outside::AskedPoints asked =
      outside::asked_points(request, "x", problem.dimension(), {.derivatives = derivatives});
  for (const Vector& x : asked.points) {
    if (x.hasNaN()) throw InputError("x must have numbers, not null");
  }
  if (asked.wanted.derivatives && !problem.differentiate) {
    throw InputError("there are no derivatives in this formulation");
  }
  if (asked.wanted.residuals && !problem.residuals) {
    throw InputError("there are no residuals in this formulation");
  }
  return asked;
}

/// Prints and flushes: the caller waits for the line. Throws std::system_error if it cannot be
/// written.
void print_line(const Json& json) {
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0) {
    throw std::system_error(errno, std::generic_category());
  }
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

/// Answers the lines of standard input one by one.
class Service {
 public:
  Service(const Problem& problem, const EvaluateOptions& options)
      : run_(problem), derivatives_(options.derivatives) {
    if (options.replay) again_.emplace(problem);
  }

  /// Throws an error if the line or a point is invalid.
  Json answer(const std::string& line) {
    const outside::AskedPoints asked = points_of(line, run_.problem(), derivatives_);
    std::vector<Json> answers;
    for (const Vector& x : asked.points) answers.push_back(answer(x, asked.wanted));
    Json json = outside::joined(std::move(answers), asked.list);
    json["evaluations"] = run_.evaluations();
    return json;
  }

  /// The answer, or an error that names the line.
  Json answer_or_error(const std::string& line, std::int64_t number) {
    try {
      return answer(line);
    } catch (const std::exception& error) {
      all_well_ = false;
      return {{"error", fmt::format("line {}: {}", number, one_line(error.what()))}};
    }
  }

  bool all_well() const { return all_well_; }

 private:
  Json answer(const Vector& x, outside::Wanted wanted) {
    const Answer answer = run_.answer(x, wanted);
    Json json = json_of(answer, wanted);
    if (again_) {
      json["same_again"] = same_bits(answer.numbers(), again_->answer(x, wanted).numbers());
      all_well_ = all_well_ && json["same_again"];
    }
    return json;
  }

  OutsideRun run_;
  std::optional<OutsideRun> again_;  // repeats every evaluation, if requested
  bool derivatives_;
  bool all_well_ = true;
};

int evaluate(const EvaluateOptions& options) {
  if (options.instance < 0) {
    throw InputError(fmt::format("--instance {}: must be >= 0", options.instance));
  }
  if (options.problem.scene_file == "-") {
    throw InputError("--scene -: must be a file, because standard input holds the points");
  }
  const Problem asked = choose_problem(options.problem, "evaluate").problem;
  const Formulation formulation = asked.formulation_named(options.formulation);
  const Problem problem = instance(asked.formulated(formulation), options.instance);
  if (options.describe) {
    print_line(description_of(asked, formulation, problem));
    return 0;
  }
  if (options.derivatives && !problem.differentiate) {
    throw InputError(fmt::format("--derivatives: {} has none in formulation {}", asked.name,
                                 asked.name_of(formulation)));
  }
  Service service(problem, options);
  std::string line;
  for (std::int64_t number = 1; read_line(line); ++number) {
    if (std::all_of(line.begin(), line.end(), is_blank)) continue;
    print_line(service.answer_or_error(line, number));
  }
  if (std::ferror(stdin) != 0) {
    throw InputError("standard input: " + std::generic_category().message(errno));
  }
  return service.all_well() ? 0 : 1;
}

}  // namespace

void add_evaluate(CommandLine& line) {
  CLI::App* command = line.add(
      "evaluate", "Evaluate a problem at points, as JSON lines",
      "  ricochet evaluate profile-count-8-C4 --formulation surrogate --instance 1 --describe\n"
      "  echo '[5.0]' | ricochet evaluate top-speed-C1\n"
      "  ricochet evaluate hs-71 --derivatives < points.jsonl > values.jsonl\n"
      "An input line is [1, 2], {\"x\": [1, 2]} or {\"x\": [1, 2], \"derivatives\": true}. Many "
      "points\n"
      "at once are [[1, 2], [3, 4]] or {\"x\": [[1, 2], [3, 4]]}: the answer has a list for each "
      "key.");
  const auto options = std::make_shared<EvaluateOptions>();
  add_problem_choice(command, options->problem);
  command->add_option("--formulation", options->formulation,
                      "Formulation of the problem; default: the true objective");
  add_value(command, "--instance", options->instance,
            "0: the original problem; 1, 2, ...: moved and reflected");
  command->add_flag("--derivatives", options->derivatives, "Print gradient and Jacobian, too");
  command->add_flag("--replay", options->replay,
                    "Evaluate every point twice and compare bit by bit");
  command->add_flag("--describe", options->describe,
                    "Print the problem in one line; evaluate nothing");
  line.on_call(command, [options] { return evaluate(*options); });
}

namespace {

/// Row by row.
Json rows_of(const Matrix& matrix) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) rows.push_back(Vector(matrix.row(i)));
  return rows;
}

void append(const auto& values, std::vector<double>& numbers) {
  const auto flat = values.reshaped();
  numbers.insert(numbers.end(), flat.begin(), flat.end());
}

}  // namespace

std::vector<double> Answer::numbers() const {
  std::vector<double> all = {told.values.objective, true_values.objective, true_values.violation};
  append(told.values.constraints, all);
  append(told.gradient, all);
  append(told.jacobian, all);
  append(residuals.values, all);
  append(residuals.jacobian, all);
  return all;
}

Json json_of(const Answer& answer, outside::Wanted wanted) {
  Json json = {{"objective", answer.told.values.objective},
               {"constraints", answer.told.values.constraints}};
  if (wanted.derivatives) {
    json["gradient"] = answer.told.gradient;
    json["jacobian"] = rows_of(answer.told.jacobian);
  }
  if (wanted.residuals) json["residuals"] = answer.residuals.values;
  if (wanted.residuals && wanted.derivatives) {
    json["residual_jacobian"] = rows_of(answer.residuals.jacobian);
  }
  json["true_values"] = {{"objective", answer.true_values.objective},
                         {"violation", answer.true_values.violation}};
  return json;
}

OutsideRun::OutsideRun(Problem problem) : problem_(std::move(problem)) {
  evaluator_.emplace(problem_, Budget{std::numeric_limits<std::int64_t>::max()});
}

Answer OutsideRun::answer(const Vector& x, outside::Wanted wanted) {
  Answer answer;
  if (wanted.derivatives) {
    if (auto told = evaluator_->derivatives(x)) answer.told = std::move(*told);
  } else {
    if (auto told = evaluator_->values(x)) answer.told.values = std::move(*told);
  }
  if (wanted.residuals && wanted.derivatives) {
    if (auto told = evaluator_->residuals(x)) answer.residuals = std::move(*told);
  } else if (wanted.residuals) {
    if (auto told = evaluator_->residual_values(x)) answer.residuals.values = *told;
  }
  if (const std::exception_ptr failure = evaluator_->failure()) {
    before_ = evaluations();
    evaluator_.emplace(problem_, Budget{std::numeric_limits<std::int64_t>::max()});
    std::rethrow_exception(failure);
  }
  const Vector inside = x.cwiseMax(problem_.lower).cwiseMin(problem_.upper);
  answer.true_values = problem_.true_values
                           ? problem_.true_values(inside)
                           : true_values_of(answer.told.values, problem_.equalities);
  return answer;
}

}  // namespace ricochet::cli
