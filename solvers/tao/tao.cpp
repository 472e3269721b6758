#include "solvers/tao/tao.h"

#include <dlfcn.h>
#include <ricochet/ricochet.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>

#include "solvers/outside/claims.h"
#include "solvers/outside/plugin.h"

namespace ricochet {
namespace {

namespace fs = std::filesystem;

/// What the library exports, in its order.
struct Exported {
  const char* name;
  bool needs_derivatives, needs_residuals;
};

constexpr Exported all[] = {{"tao-blmvm", true, false},
                            {"tao-bqnls", true, false},
                            {"tao-bncg", true, false},
                            {"tao-pounders", false, true},
                            {"tao-brgn", false, true}};

/// Where it is installed, seen from the program, or else where it was built; empty where it is not.
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

/// Its own symbols before those of the program: Ipopt's sequential MUMPS brings functions of MPI
/// that do nothing.
const ricochet_solver* loaded(const std::string& path) {
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_DEEPBIND);
  const void* exported = library != nullptr ? dlsym(library, "ricochet_tao_solvers") : nullptr;
  if (exported == nullptr) throw std::runtime_error(dlerror());
  // What PETSc brings along flushes at the program's end a std::cout that, loaded so, is none. This
  // comes before it, as it is registered later, and leaves nothing else undone.
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

std::vector<Solver> tao_solvers() {
  const std::string path = library_path();
  // To load PETSc in order to see whether it loads would cost every program a twentieth of a
  // second.
  if (path.empty() || !fs::exists(RICOCHET_PETSC_FILE)) return {};
  std::vector<Solver> solvers;
  for (std::size_t k = 0; k < std::size(all); ++k) {
    const auto& [name, derivatives, residuals] = all[k];
    Solver solver = outside::solver_as_claimed(
        {name, "PETSc " RICOCHET_PETSC_VERSION, 0, derivatives, residuals, false}, path);
    solver.solve = [k, path](Evaluator& evaluator, const Vector& start, Random& random) {
      static const ricochet_solver* const exported = loaded(path);
      return outside::solve_by(exported[k], path, evaluator, start, random);
    };
    solvers.push_back(std::move(solver));
  }
  return solvers;
}

}  // namespace ricochet
