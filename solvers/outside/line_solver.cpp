#include "solvers/outside/line_solver.h"

#include <fmt/format.h>
#include <wordexp.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "ricochet/error.h"
#include "ricochet/evaluator.h"
#include "solvers/outside/outside.h"
#include "solvers/outside/plugin.h"
#include "solvers/scaled_box.h"
#include "src/core/names.h"

/// The protocol between a solver and ricochet: every line is a JSON object; null stands for a
/// number that is not finite. A violation throws std::runtime_error, which names the line and shows
/// its beginning.
namespace ricochet::outside {

/// Sends `first` and the evaluator's problem to a program and answers its requests until it is
/// done. Returns nothing if the program ended before it wrote a line. Once the run is over, the
/// program may end without reporting that it is done.
std::optional<SolverTermination> converse(LineProgram& program, Evaluator& evaluator,
                                          const Vector& start, std::uint32_t seed,
                                          const std::string& first);

std::vector<std::string> words_of(const std::string& command) {
  wordexp_t found{};
  const int code = wordexp(command.c_str(), &found, WRDE_NOCMD);
  std::vector<std::string> words;
  if (code == 0) words.assign(found.we_wordv, found.we_wordv + found.we_wordc);
  if (code == 0 || code == WRDE_NOSPACE) wordfree(&found);
  if (words.empty()) {
    throw InputError(command + ": is not one program with its arguments; put what a shell shall " +
                     "do into a script");
  }
  return words;
}

SolverTermination WaitingPrograms::solve(Evaluator& evaluator, const Vector& start, Random& random,
                                         const std::string& first) {
  const auto seed = static_cast<std::uint32_t>(random() >> 32U);
  const auto exit_of = [&](LineProgram& program) {
    return converse(program, evaluator, start, seed, first);
  };
  std::optional<SolverTermination> exit;
  std::unique_ptr<LineProgram> program = waiting_.take();
  if (program) exit = exit_of(*program);
  if (!exit) {
    program = start_();
    exit = exit_of(*program);
  }
  if (!exit) throw std::runtime_error(program->how_it_ended() + " when it was given a problem");
  give_back(std::move(program));
  return *exit;
}

Solver line_solver(const std::string& command) {
  const std::vector<std::string> words = words_of(command);
  const Content content = content_of_command(words);  // before it is started
  Claims claims;
  const auto started = [words](Claims& told) {
    auto program = std::make_unique<LineProgram>(words);
    told = greeting_of(*program);
    return program;
  };
  const auto programs = std::make_shared<WaitingPrograms>([started] {
    Claims known;
    return started(known);
  });
  try {
    programs->give_back(started(claims));
  } catch (const std::exception& error) {
    throw InputError(command + ": " + error.what());
  }
  Solver solver = solver_as_claimed(claims, command);
  solver.content = content.hash();
  solver.changed_file = [content] { return content.changed(); };
  solver.solve = [programs, command](Evaluator& evaluator, const Vector& start, Random& random) {
    try {
      return programs->solve(evaluator, start, random);
    } catch (const std::exception& error) {
      throw std::runtime_error(command + ": " + error.what());
    }
  };
  return solver;
}

namespace {

using Json = nlohmann::ordered_json;

constexpr std::chrono::seconds patience{60};  // importing a large library takes long
constexpr int most_asked_when_over = 500;     // the same for every solver; see the tests
constexpr std::size_t shown_of_a_line = 80;   // bytes

/// One line of a program: an object with allowed keys only.
class Message {
 public:
  Message(const LineProgram& program, std::string_view line)
      : number_(program.lines()), line_(line), content_(Json::parse(line, nullptr, false)) {
    if (content_.is_discarded()) {
      refuse("is no JSON (what is for people to read belongs on standard error)");
    }
    if (!content_.is_object()) refuse("is no JSON object");
  }

  void allow(const std::vector<std::string>& keys) const {
    for (const auto& [key, value] : content_.items()) {
      if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
      refuse(fmt::format("knows no \"{}\"; {}", key, what_instead(key, keys)));
    }
  }

  bool has(const char* key) const { return content_.contains(key); }

  /// The value of the key, or `otherwise` if it is missing; `is` checks that it has the described
  /// type.
  template <class T>
  T get(const char* key, T otherwise, bool (Json::*is)() const noexcept, const char* type) const {
    if (!has(key)) return otherwise;
    if (!(content_[key].*is)()) refuse(fmt::format("\"{}\" is no {}", key, type));
    return content_[key].get<T>();
  }
  std::string text(const char* key) const {
    return get(key, std::string(), &Json::is_string, "text in quotes");
  }
  bool flag(const char* key) const { return get(key, false, &Json::is_boolean, "true or false"); }

  AskedPoints asked(Eigen::Index dimension) const {
    return understood([&] { return asked_points(content_, "ask", dimension); });
  }
  Vector point(const char* key, Eigen::Index dimension) const {
    return understood([&] { return asked_point(content_[key], key, dimension); });
  }

  [[noreturn]] void refuse(const std::string& reason) const {
    throw std::runtime_error(fmt::format("output line {} {}: {}{}", number_, reason,
                                         one_line(line_.substr(0, shown_of_a_line)),
                                         line_.size() > shown_of_a_line ? "..." : ""));
  }

 private:
  /// What `read` returns; an InputError names the line.
  template <class Read>
  std::invoke_result_t<const Read&> understood(const Read& read) const {
    try {
      return read();
    } catch (const InputError& error) {
      refuse(error.what());
    }
  }

  int number_;
  std::string_view line_;
  Json content_;
};

Json list_of(const Vector& vector) {
  Json list = Json::array();
  for (const double value : vector) list.push_back(value);
  return list;
}

Json rows_of(const Matrix& matrix) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) rows.push_back(list_of(matrix.row(i)));
  return rows;
}

void send(LineProgram& program, const Json& message) {
  // Names of problems come from the user: invalid UTF-8 in them is replaced.
  program.send(message.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
}

Json description_of(Evaluator& evaluator, const Vector& start, std::uint32_t seed) {
  return {{"ricochet", 1},
          {"name", evaluator.name()},
          {"dimension", evaluator.dimension()},
          {"lower", list_of(evaluator.lower())},
          {"upper", list_of(evaluator.upper())},
          {"start", list_of(start)},
          {"constraints", evaluator.constraints()},
          {"equalities", evaluator.equalities()},
          {"derivatives", evaluator.has_derivatives()},
          {"residuals", evaluator.has_residuals()},
          {"budget", evaluator.remaining()},
          {"seed", seed}};
}

/// The residuals at a point, with their Jacobian if `derivatives`; nothing once the run is over.
std::optional<Json> told_residuals(Evaluator& evaluator, const Vector& x, bool derivatives) {
  if (!derivatives) {
    const auto values = evaluator.residual_values(x);
    if (!values) return std::nullopt;
    return Json{{"residuals", list_of(*values)}};
  }
  const auto known = evaluator.residuals(x);
  if (!known) return std::nullopt;
  return Json{{"residuals", list_of(known->values)},
              {"residual_jacobian", rows_of(known->jacobian)}};
}

/// The reply for one point; nothing once the run is over.
std::optional<Json> told(Evaluator& evaluator, const Vector& x, bool derivatives) {
  if (!derivatives) {
    const auto values = evaluator.values(x);
    if (!values) return std::nullopt;
    return Json{{"objective", values->objective}, {"constraints", list_of(values->constraints)}};
  }
  const auto known = evaluator.derivatives(x);
  if (!known) return std::nullopt;
  return Json{{"objective", known->values.objective},
              {"constraints", list_of(known->values.constraints)},
              {"gradient", list_of(known->gradient)},
              {"jacobian", rows_of(known->jacobian)}};
}

/// The reply to a request; nothing once the run is over.
std::optional<Json> answer(Evaluator& evaluator, const Message& message) {
  const AskedPoints asked = message.asked(evaluator.dimension());
  const auto [derivatives, residuals] = asked.wanted;
  if (residuals && !evaluator.has_residuals()) {
    message.refuse("wants residuals, but the problem has none");
  }
  if (derivatives && !residuals && !evaluator.has_derivatives()) {
    message.refuse("wants derivatives, but the problem has none");
  }
  std::vector<Json> replies;
  for (const Vector& x : asked.points) {
    std::optional<Json> one =
        residuals ? told_residuals(evaluator, x, derivatives) : told(evaluator, x, derivatives);
    if (!one) return std::nullopt;
    replies.push_back(std::move(*one));
  }
  Json result = joined(std::move(replies), asked.list);
  result["remaining"] = evaluator.remaining();
  return result;
}

SolverTermination exit_of(const Evaluator& evaluator, const Message& message) {
  message.allow({"done", "point"});
  SolverTermination exit{one_line(message.text("done"))};
  if (message.has("point")) {
    exit.point = message.point("point", evaluator.dimension());
  }
  if (evaluator.over()) exit.reason = stopped_by_evaluator;
  return exit;
}

}  // namespace

Claims greeting_of(LineProgram& program) {
  const auto line = program.line(Patience{patience, "it was started"});
  if (!line) throw std::runtime_error(program.how_it_ended() + ", and has not said what it is");
  const Message greeting(program, *line);
  greeting.allow({"name", "version", "takes_constraints", "needs_derivatives", "needs_residuals",
                  "stochastic"});
  return {greeting.text("name"),
          greeting.text("version"),
          greeting.get("takes_constraints", 0, &Json::is_number_integer, "whole number"),
          greeting.flag("needs_derivatives"),
          greeting.flag("needs_residuals"),
          greeting.flag("stochastic")};
}

std::optional<SolverTermination> converse(LineProgram& program, Evaluator& evaluator,
                                          const Vector& start, std::uint32_t seed,
                                          const std::string& first) {
  if (program.has_spoken()) {
    throw std::runtime_error(
        fmt::format("spoke after output line {}, when it was done", program.lines()));
  }
  const int lines_before = program.lines();
  program.send(first);
  send(program, description_of(evaluator, start, seed));
  int asked_when_over = 0;
  for (;;) {
    const auto line =
        program.line(evaluator.over() ? Patience{patience, "it was told to stop"} : Patience{});
    if (!line && program.lines() == lines_before) return std::nullopt;
    if (!line && evaluator.over()) return SolverTermination{stopped_by_evaluator};
    if (!line)
      throw std::runtime_error(program.how_it_ended() + ", and has not said that it is done");
    const Message message(program, *line);
    if (message.has("done")) return exit_of(evaluator, message);
    if (!message.has("ask")) message.refuse("has neither \"ask\" nor \"done\"");
    if (evaluator.over() && ++asked_when_over > most_asked_when_over) {
      message.refuse("asks on, long after it was told to stop");
    }
    const std::optional<Json> found = evaluator.over() ? std::nullopt : answer(evaluator, message);
    send(program, found ? *found : Json{{"stop", true}});
  }
}

}  // namespace ricochet::outside
