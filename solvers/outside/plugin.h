#pragma once

#include <ricochet/ricochet.h>

#include <string>

#include "src/core/solver.h"

namespace ricochet::outside {

/// The solver that the shared library at `path`, which holds a /, exports as ricochet_plugin; see
/// include/ricochet/ricochet.h. Its name is the file's where it has none. The library stays until
/// the program ends. What its solver throws ends the run. Throws InputError where the file is no
/// library, or the library is no such solver.
Solver plugin(const std::string& path);

/// One start of a solver that the shared library at `path` exports, as Solver::solve. Throws
/// std::runtime_error, naming the path, for what the solver throws.
SolverExit solve_by(const ricochet_solver& exported, const std::string& path, Evaluator& evaluator,
                    const Vector& start, Random& random);

}  // namespace ricochet::outside
