#pragma once

#include <ricochet/ricochet.h>

#include <string>

#include "ricochet/solver.h"

namespace ricochet::outside {

/// The solver that the shared library at `path`, which contains a /, exports as ricochet_plugin;
/// see include/ricochet/ricochet.h. If it has no name, the file's name is used. The library is
/// loaded in another process to learn what it claims, and in this one when `solve` is first called;
/// it stays loaded until that process ends. An exception of the solver ends the run. Throws
/// InputError if the file is no library, the library is no such solver, or loading it crashes or
/// takes more than 10 s or 2 GB.
Solver plugin(const std::string& path);

/// One start of a solver that the shared library at `path` exports, as Solver::solve. Throws
/// std::runtime_error, naming the path, if the solver throws.
SolverTermination solve_by(const ricochet_solver& exported, const std::string& path,
                           Evaluator& evaluator, const Vector& start, Random& random);

}  // namespace ricochet::outside
