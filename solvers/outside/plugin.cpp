#include "solvers/outside/plugin.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <link.h>
#include <ricochet/ricochet.h>

#include <chrono>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "ricochet/error.h"
#include "solvers/outside/claims.h"
#include "solvers/outside/content.h"
#include "solvers/unit_box.h"
#include "src/core/floating_point.h"
#include "src/core/isolated_call.h"
#include "src/core/one_line.h"
#include "src/interface/seen_problem.h"

namespace ricochet::outside {
namespace {

using Json = nlohmann::json;

constexpr std::chrono::seconds longest_load{10};
constexpr double most_memory = 2000;  // [MB]

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
  throw InputError(path + ": " + reason);
}

const ricochet_solver& exported_by(const std::string& path) {
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  reset_floating_point();  // its constructors may have changed it
  if (library == nullptr) {
    const std::string reason = dlerror();
    throw InputError(reason.starts_with(path) ? reason : path + ": " + reason);
  }
  const auto* exported = static_cast<const ricochet_solver*>(dlsym(library, "ricochet_plugin"));
  if (exported == nullptr) {
    refuse(path, "exports no ricochet_plugin; does it include <ricochet/ricochet.h>?");
  }
  if (exported->abi != RICOCHET_ABI) {
    refuse(path, fmt::format("is made for interface {}, this is {}; compile it again",
                             exported->abi, RICOCHET_ABI));
  }
  if (exported->solve == nullptr) refuse(path, "solve is NULL");
  return *exported;
}

/// The files of the shared libraries that this process has loaded, without those of the system.
std::set<std::string> loaded_libraries() {
  std::set<std::string> files;
  dl_iterate_phdr(
      [](dl_phdr_info* info, std::size_t, void* found) {
        const std::string name = info->dlpi_name;
        const bool own = name.find('/') != std::string::npos && !is_of_the_system(name);
        if (own) static_cast<std::set<std::string>*>(found)->insert(name);
        return 0;
      },
      &files);
  return files;
}

/// The claims of a library as JSON text, and the libraries that it brings along. To be called where
/// a library may do what it likes: its constructors run, and its pointers are followed.
std::string claims_text(const std::string& path) {
  const std::set<std::string> before = loaded_libraries();
  const ricochet_solver& exported = exported_by(path);
  std::vector<std::string> brought;
  for (const std::string& file : loaded_libraries()) {
    if (file != path && !before.contains(file)) brought.push_back(file);
  }
  const Json claims = {
      {"name", exported.name != nullptr ? std::string(exported.name)
                                        : std::filesystem::path(path).stem().string()},
      {"version", exported.version != nullptr ? exported.version : ""},
      {"takes_constraints", exported.takes_constraints},
      {"needs_derivatives", exported.needs_derivatives != 0},
      {"needs_residuals", exported.needs_residuals != 0},
      {"stochastic", exported.stochastic != 0},
      {"brought", brought}};
  return claims.dump(-1, ' ', false, Json::error_handler_t::replace);
}

/// The claims of a library, which is loaded for this in another process. Adds the libraries that it
/// brings along to what the solver consists of.
Claims claims_of(const std::string& path, Content& content) {
  try {
    const Json claims = Json::parse(
        called_in_isolation([&] { return claims_text(path); }, longest_load, most_memory));
    for (const Json& file : claims.at("brought")) content.add_file(file.get<std::string>());
    return {claims.at("name").get<std::string>(),      claims.at("version").get<std::string>(),
            claims.at("takes_constraints").get<int>(), claims.at("needs_derivatives").get<bool>(),
            claims.at("needs_residuals").get<bool>(),  claims.at("stochastic").get<bool>()};
  } catch (const std::runtime_error& error) {
    const std::string reason = error.what();
    if (reason.starts_with(path)) throw InputError(reason);
    refuse(path, "cannot be loaded: the process that tried it " + reason);
  }
}

/// An exception thrown from here holds no reference to the library.
const char* solved(const ricochet_solver& exported, ricochet_problem* problem, Vector& point,
                   const std::string& path) {
  try {
    return exported.solve(problem, point.data());
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  } catch (...) {
    throw std::runtime_error(path + ": threw what is no std::exception");
  }
}

}  // namespace

Solver plugin(const std::string& path) {
  Content content;
  content.add_file(path);  // before it is loaded
  Solver solver = solver_as_claimed(claims_of(path, content), path);
  solver.content = content.hash();
  solver.changed_file = [content] { return content.changed(); };
  solver.solve = [path](Evaluator& evaluator, const Vector& start, Random& random) {
    return solve_by(exported_by(path), path, evaluator, start, random);
  };
  return solver;
}

SolverTermination solve_by(const ricochet_solver& exported, const std::string& path,
                           Evaluator& evaluator, const Vector& start, Random& random) {
  interface::SeenProblem problem(evaluator, start, random);
  problem.answer_this_thread_only();
  Vector point = start;
  const char* said = solved(exported, &problem, point, path);
  if (problem.failure()) std::rethrow_exception(problem.failure());
  if (problem.was_asked_by_others()) {
    throw std::runtime_error(path + ": asked its problem from a second thread");
  }
  SolverTermination exit{said != nullptr ? one_line(said) : "done"};
  if (evaluator.over()) exit.reason = stopped_by_evaluator;
  // A point left as it was is none, but for a solver that requested residuals only.
  if (point != start || evaluator.best_shown() == nullptr) exit.point = point;
  return exit;
}

}  // namespace ricochet::outside
