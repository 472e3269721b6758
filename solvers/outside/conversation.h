#pragma once

#include <cstdint>
#include <optional>

#include "solvers/outside/claims.h"
#include "solvers/outside/line_program.h"
#include "src/core/evaluator.h"

/// What a solver and ricochet say to each other: every line is a JSON object, and null stands for a
/// number that is not finite. What breaks these rules is a std::runtime_error that names the line
/// and shows its beginning.
namespace ricochet::outside {

/// The program's first line: what it is.
Claims greeting_of(LineProgram& program);

/// Puts the evaluator's problem to a program and answers it until it is done. Nothing where it
/// ended before it wrote a line. Once the run is over, it may end instead of saying that it is
/// done.
std::optional<SolverExit> converse(LineProgram& program, Evaluator& evaluator, const Vector& start,
                                   std::uint32_t seed);

}  // namespace ricochet::outside
