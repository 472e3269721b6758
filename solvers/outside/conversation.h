#pragma once

#include <cstdint>
#include <optional>

#include "ricochet/evaluator.h"
#include "solvers/outside/claims.h"
#include "solvers/outside/line_program.h"

/// The protocol between a solver and ricochet: every line is a JSON object; null stands for a
/// number that is not finite. A violation throws std::runtime_error, which names the line and shows
/// its beginning.
namespace ricochet::outside {

/// Reads the program's first line: its claims.
Claims greeting_of(LineProgram& program);

/// Sends the evaluator's problem to a program and answers its requests until it is done. Returns
/// nothing if the program ended before it wrote a line. Once the run is over, the program may end
/// without reporting that it is done.
std::optional<SolverTermination> converse(LineProgram& program, Evaluator& evaluator,
                                          const Vector& start, std::uint32_t seed);

}  // namespace ricochet::outside
