#include <stdexcept>

#include "solvers/adjustable_solver.h"
#include "solvers/library_solvers.h"

/// In the place of solvers/dlib.cpp: Debian's static library of dlib cannot be a part of a shared
/// one, and its shared one brings 70 MB of data sets. The linker takes these, as they come first.
namespace ricochet {

Solver dlib_global_search() {
  Solver solver;
  solver.name = "dlib-global-search";
  solver.capabilities = dlib_capabilities;
  solver.solve = [](Evaluator&, const Vector&, Random&) -> SolverTermination {
    throw std::runtime_error("dlib-global-search runs in the program ricochet only");
  };
  return solver;
}

AdjustableSolver adjustable_dlib() {
  return {"dlib-global-search", {}, [](const GivenOptions&) { return dlib_global_search(); }};
}

}  // namespace ricochet
