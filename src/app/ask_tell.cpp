#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <iostream>

#include "ricochet/error.h"
#include "ricochet/run.h"
#include "ricochet/solver.h"
#include "src/app/command_line.h"
#include "src/app/problem_choice.h"
#include "src/core/names.h"
#include "src/report/text.h"

/// Problems whose values are found elsewhere, in a laboratory or a queue: a solver asks for points,
/// and somebody tells their values, days later if need be. The solver is not kept waiting: it is
/// replayed through what was told, to the first point that was not.
namespace ricochet::cli {

namespace {

using own::AskedPoint;
using own::Given;
using own::OwnProblem;
using report::Json;

struct AskOptions {
  std::string file;
  std::string solver = "auto";
  std::int64_t budget = 1000;  ///< evaluations
  int seed = 0;
  bool json = false;
};

struct TellOptions {
  std::string file;
  std::int64_t id = 0;  ///< 0: lines of standard input
  std::vector<std::string> values;
  std::string failed;  ///< why there are no values
  bool replace = false;
  bool json = false;
};

/// A problem file, or that of a folder, of which the values are told.
own::ProblemFile told_file(const std::string& name) {
  const bool folder = std::filesystem::is_directory(name);
  own::ProblemFile file = own::read_problem_file(folder ? name + "/problem.toml" : name);
  if (!file.program.told) {
    throw InputError(file.path.string() +
                     ": a program computes its values; where they are told, write told = true in "
                     "place of the program");
  }
  return file;
}

/// What `tell` takes behind the number of a point.
std::string expected(const own::ProblemFile& file) {
  return fmt::format("{}", fmt::join(file.program.outputs, " "));
}

Json named_point(const own::ProblemFile& file, const AskedPoint& point) {
  Json named = Json::object();
  for (std::size_t i = 0; i < file.variables.size(); ++i) {
    named[file.variables[i].name] = point.x[static_cast<Eigen::Index>(i)];
  }
  return {{"id", point.id}, {"point", named}, {"derivatives", point.derivatives}};
}

void print(const own::ProblemFile& file, const AskedPoint& point) {
  for (std::size_t i = 0; i < file.variables.size(); ++i) {
    const own::FileVariable& v = file.variables[i];
    fmt::print("  {} = {:.17g}{}{}\n", v.name, point.x[static_cast<Eigen::Index>(i)],
               v.unit.empty() ? "" : " ", v.unit);
  }
}

int ask_point(const AskOptions& options) {
  check_budget(options.budget);
  check_seed(options.seed);
  const Solver solver = named(
      all_solvers(), options.solver, "--solver", [](const Solver& s) { return s.name; },
      "`ricochet list solvers`");
  const own::ProblemFile file = told_file(options.file);
  const OwnProblem own(file, fmt::format("{} seed {}", solver.name, options.seed));
  const Formulation formulation = accepted_formulation(own.problem(), solver);
  const Problem problem = own.problem().formulated(formulation);
  Budget budget{options.budget};
  budget.gradient_price = problem.gradient_cost;
  RunRecord record;
  run_all({{&problem, &solver, budget, options.seed, problem.name_of(formulation)}}, Limits{},
          [&record](std::size_t, RunRecord made) { record = std::move(made); });

  const std::int64_t id = own.counts().asked;
  const std::vector<AskedPoint> asked = own.store().asked();
  const auto point = std::ranges::find(asked, id, &AskedPoint::id);
  if (point == asked.end() && !record.failure.empty()) throw std::runtime_error(record.failure);
  std::optional<OwnAnswer> best;
  if (!record.trace.empty()) {
    const Improvement& last = record.trace.back();
    const double objective = last.true_values.objective;
    best = answer_at(own, last.x, own.problem().maximises ? 0 - objective : objective, 0);
  }
  if (options.json) {
    Json data = point == asked.end() ? Json{{"id", nullptr}} : named_point(file, *point);
    data["evaluations"] = record.ledger.charged;
    data.update(json_of(own, own.counts(), best));
    fmt::print("{}\n", data.dump(2));
    return 0;
  }
  if (point != asked.end()) {
    fmt::print("Point {} of {}, after {} of {}:\n", id, solver.name, record.ledger.charged,
               report::counted(options.budget, "evaluation"));
    print(file, *point);
    fmt::print("Its values: ricochet tell {} {} {}\n", options.file, id, expected(file));
  } else {
    fmt::print("{} is done, after {}.\n", solver.name,
               report::counted(record.ledger.charged, "evaluation"));
  }
  if (best) {
    fmt::print("Best so far: {:.9g}{}{}\n{}", best->objective, file.unit.empty() ? "" : " ",
               file.unit, in_words(own, *best));
  }
  return 0;
}

/// Keeps what is told of a point.
void tell_point(const OwnProblem& own, const AskedPoint& point, bool replace,
                const std::function<Given(bool derivatives)>& values) {
  if (point.told && !replace) {
    throw InputError(
        fmt::format("point {}: is told already; --replace takes the new values", point.id));
  }
  Given given;
  try {
    given = values(point.derivatives);
  } catch (const InputError& error) {
    throw InputError(fmt::format("point {}: {}", point.id, error.what()));
  } catch (const std::runtime_error& error) {  // there are none, and that is said
    given = own::nothing_given(own.file(), point.derivatives);
    given.failure = one_line(error.what());
  }
  if (point.told) own.store().forget(point);
  own.store().keep(own.file(), point.key, point.x, point.derivatives, given);
}

/// The point of this number. Throws InputError if it was not asked for.
AskedPoint point_numbered(const OwnProblem& own, std::int64_t id) {
  std::vector<std::int64_t> waiting;
  for (const AskedPoint& each : own.store().asked()) {
    if (each.id == id) return each;
    if (!each.told) waiting.push_back(each.id);
  }
  throw InputError(fmt::format("point {}: was not asked for; {}", id,
                               waiting.empty()
                                   ? "`ricochet ask` says what is"
                                   : fmt::format("these are: {}", fmt::join(waiting, ", "))));
}

/// Tells all of a line of JSON, which has the point's number as its "id".
void tell_line(const OwnProblem& own, const std::string& line, bool replace) {
  Json answer;
  try {
    answer = Json::parse(line);
  } catch (const Json::exception&) {
    throw InputError("is no JSON: " + one_line(line.substr(0, 80)));
  }
  if (!answer.is_object() || !answer.contains("id") || !answer["id"].is_number_integer()) {
    throw InputError("must be an object with \"id\", the number of a point");
  }
  const auto id = answer["id"].get<std::int64_t>();
  answer.erase("id");
  tell_point(own, point_numbered(own, id), replace, [&](bool derivatives) {
    return own::given_in_line(own.file(), answer.dump(), derivatives);
  });
}

int tell_values(const TellOptions& options) {
  const OwnProblem own(told_file(options.file));
  std::int64_t told = 0;
  if (options.id == 0) {
    std::int64_t number = 0;
    for (std::string line; std::getline(std::cin, line);) {
      ++number;
      if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
      try {
        tell_line(own, line, options.replace);
      } catch (const InputError& error) {
        throw InputError(
            fmt::format("line {}: {}; {} kept", number, error.what(),
                        report::counted(told, "earlier line is", "earlier lines are")));
      }
      ++told;
    }
  } else {
    const AskedPoint point = point_numbered(own, options.id);
    if (options.values.empty() == options.failed.empty()) {
      throw InputError(fmt::format("point {}: needs either its values, {}, or --failed", options.id,
                                   expected(own.file())));
    }
    if (point.derivatives && options.failed.empty()) {
      throw InputError(fmt::format(
          "point {}: derivatives are asked for, too: tell them as a line of JSON", options.id));
    }
    tell_point(own, point, options.replace, [&](bool) {
      if (!options.failed.empty()) throw std::runtime_error(options.failed);
      return own::given_in_numbers(own.file(), fmt::format("{}", fmt::join(options.values, "\n")));
    });
    told = 1;
  }
  const auto asked = own.store().asked();
  const auto waiting = std::ranges::count(asked, false, &AskedPoint::told);
  fmt::print("{} told; {} still waiting.\n", report::counted(told, "point"), waiting);
  return 0;
}

}  // namespace

void add_ask(CommandLine& line) {
  CLI::App* command =
      line.add("ask", "Ask for the next point of a problem whose values you find yourself",
               "  ricochet ask mine.toml\n"
               "  ricochet ask mine.toml --solver nlopt-cobyla --budget 60 --format json");
  const auto options = std::make_shared<AskOptions>();
  add_value(command, "file", options->file,
            "A problem file (TOML) with told = true, or a folder with problem.toml", "FILE")
      ->required();
  add_value(command, "--solver", options->solver, "A name of `ricochet list solvers`");
  add_value(command, "--budget", options->budget, "Evaluations that you can pay");
  add_value(command, "--seed", options->seed, "Number of the run, which gives its random numbers");
  add_format(command, options->json);
  line.on_call(command, [options] { return ask_point(*options); });
}

void add_tell(CommandLine& line) {
  CLI::App* command = line.add("tell", "Tell the values at a point that `ask` printed",
                               "  ricochet tell mine.toml 7 12.5 -0.3\n"
                               "  ricochet tell mine.toml 8 --failed 'the specimen broke'\n"
                               "  ricochet tell mine.toml < values.jsonl");
  const auto options = std::make_shared<TellOptions>();
  add_value(command, "file", options->file, "As for `ask`", "FILE")->required();
  command->add_option("id", options->id,
                      "Number of the point; without it, lines of JSON are read: {\"id\": 7, "
                      "\"objective\": 12.5, \"constraints\": [-0.3]}");
  command->add_option("values", options->values,
                      "Objective (or residuals) and constraints, in the order of the file");
  command->add_option("--failed", options->failed, "There are no values, for this reason");
  command->add_flag("--replace", options->replace, "Take back what was told of the point before");
  line.on_call(command, [options] { return tell_values(*options); });
}

}  // namespace ricochet::cli
