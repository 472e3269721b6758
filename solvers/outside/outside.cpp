#include "solvers/outside/outside.h"

#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "ricochet/error.h"
#include "solvers/outside/line_solver.h"
#include "solvers/outside/plugin.h"

namespace ricochet::outside {

namespace {

enum class Kind { name, library, program };

Kind kind_of(const std::string& text) {
  const bool has_space = text.find(' ') != std::string::npos;
  const bool is_path = text.find('/') != std::string::npos;
  std::error_code ignored;
  const bool is_file = std::filesystem::is_regular_file(text, ignored);
  if (!has_space && !is_path) {
    if (is_file && text.find('.') != std::string::npos) {
      throw InputError(text + ": a file is given with its folder, ./" + text);
    }
    return Kind::name;
  }
  if (is_path && text.ends_with(".so") && (is_file || !has_space)) return Kind::library;
  if (has_space) return Kind::program;
  if (!is_file) throw InputError(text + ": there is no such file");
  if (access(text.c_str(), X_OK) != 0) {
    throw InputError(text + ": is neither executable nor named .so; what runs it? " +
                     "For example \"python3 " + text + "\"");
  }
  return Kind::program;
}

}  // namespace

bool is_outside(const std::string& text) {
  return kind_of(text) != Kind::name;
}

std::optional<Solver> outside_solver(const std::string& text) {
  switch (kind_of(text)) {
    case Kind::library:
      return plugin(text);
    case Kind::program:
      return line_solver(text);
    default:
      return std::nullopt;
  }
}

std::optional<Solver> unstarted_solver(const std::string& text) {
  if (!is_outside(text)) return std::nullopt;
  Solver solver;
  solver.name = text;
  solver.capabilities.constraints = Capabilities::Constraints::all;
  solver.solve = [text](Evaluator&, const Vector&, Random&) -> SolverTermination {
    throw std::logic_error(text + ": was not started");
  };
  return solver;
}

}  // namespace ricochet::outside
