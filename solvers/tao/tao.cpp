#include <dlfcn.h>
#include <ricochet/ricochet.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>

#include "solvers/library_solvers.h"
#include "solvers/outside/plugin.h"
#include "solvers/scaled_box.h"

namespace ricochet {

namespace {

namespace fs = std::filesystem;

struct Options {
  Coordinates coordinates = Coordinates::own;
};

/// The solvers that the library exports, in its order; each once for each of the coordinates.
struct Exported {
  const char* name;
  Capabilities capabilities;
  Options own = {};
};

constexpr Exported all[] = {
    {"tao-blmvm", tao_gradient_capabilities},
    {"tao-bqnls", tao_gradient_capabilities},
    {"tao-bncg", tao_gradient_capabilities},
    {"tao-pounders", tao_residual_capabilities, {.coordinates = Coordinates::unit}},
    {"tao-brgn", tao_residual_capabilities}};

template <class Visit, IsOf<Options>... O>
void visit_fields(const Visit& visit, O&... o) {
  visit(coordinates_option, o.coordinates...);
}

/// Path where the library is installed, relative to the program, or else where it was built; empty
/// if it is missing.
std::string library_path() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path installed =
      program.parent_path().parent_path() / RICOCHET_LIBRARY_FOLDER / "libricochet_tao.so";
  for (const fs::path& path : {installed, fs::path(RICOCHET_TAO_BUILT)}) {
    if (fs::exists(path, error)) return path.string();
  }
  return {};
}

/// Loads it with its own symbols before those of the program: Ipopt's sequential MUMPS brings MPI
/// functions that do nothing.
const ricochet_solver* loaded(const std::string& path) {
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_DEEPBIND);
  const void* exported = library != nullptr ? dlsym(library, "ricochet_tao_solvers") : nullptr;
  if (exported == nullptr) throw std::runtime_error(dlerror());
  // At the program's end PETSc's dependencies flush a std::cout that, loaded this way, is not
  // valid. This handler is registered later, so it runs before, and skips nothing else.
  on_exit(
      [](int status, void* /*nothing*/) {
        std::cout.flush();
        std::fflush(nullptr);
        _exit(status);
      },
      nullptr);
  return static_cast<const ricochet_solver*>(exported);
}

}  // namespace

std::vector<AdjustableSolver> adjustable_tao() {
  const std::string path = library_path();
  // Loading PETSc to see whether it loads would cost every program a twentieth of a second.
  if (path.empty() || !fs::exists(RICOCHET_PETSC_FILE)) return {};
  std::vector<AdjustableSolver> solvers;
  for (std::size_t k = 0; k < std::size(all); ++k) {
    solvers.push_back(adjustable(all[k].name, all[k].own, [k, path](const Options& options) {
      Solver solver;
      solver.name = all[k].name;
      solver.version = "PETSc " RICOCHET_PETSC_VERSION;
      if (options.coordinates == Coordinates::own) solver.version += " (adapter 2)";
      solver.capabilities = all[k].capabilities;
      const std::size_t place = 3 * k + static_cast<std::size_t>(options.coordinates);
      solver.solve = [place, path](Evaluator& evaluator, const Vector& start, Random& random) {
        static const ricochet_solver* const exported = loaded(path);
        return outside::solve_by(exported[place], path, evaluator, start, random);
      };
      return solver;
    }));
  }
  return solvers;
}

std::vector<Solver> tao_solvers() {
  std::vector<Solver> solvers;
  for (const AdjustableSolver& solver : adjustable_tao()) solvers.push_back(solver.with({}));
  return solvers;
}

}  // namespace ricochet
