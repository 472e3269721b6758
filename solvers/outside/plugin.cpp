#include "solvers/outside/plugin.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <ricochet/ricochet.h>

#include <exception>
#include <filesystem>
#include <stdexcept>

#include "ricochet/error.h"
#include "solvers/outside/claims.h"
#include "solvers/unit_box.h"
#include "src/core/one_line.h"
#include "src/interface/seen_problem.h"

namespace ricochet::outside {
namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& reason) {
  throw InputError(path + ": " + reason);
}

const ricochet_solver& exported_by(const std::string& path) {
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
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

Claims claims_of(const ricochet_solver& exported, const std::string& path) {
  return {exported.name != nullptr ? exported.name : std::filesystem::path(path).stem().string(),
          exported.version != nullptr ? exported.version : "",
          exported.takes_constraints,
          exported.needs_derivatives != 0,
          exported.needs_residuals != 0,
          exported.stochastic != 0};
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
  const ricochet_solver& exported = exported_by(path);
  Solver solver = solver_as_claimed(claims_of(exported, path), path);
  solver.solve = [&exported, path](Evaluator& evaluator, const Vector& start, Random& random) {
    return solve_by(exported, path, evaluator, start, random);
  };
  return solver;
}

SolverTermination solve_by(const ricochet_solver& exported, const std::string& path,
                           Evaluator& evaluator, const Vector& start, Random& random) {
  interface::SeenProblem problem(evaluator, start, random);
  Vector point = start;
  const char* said = solved(exported, &problem, point, path);
  if (problem.failure()) std::rethrow_exception(problem.failure());
  SolverTermination exit{said != nullptr ? one_line(said) : "done"};
  if (evaluator.over()) exit.reason = stopped_by_evaluator;
  if (point != start) exit.point = point;
  return exit;
}

}  // namespace ricochet::outside
