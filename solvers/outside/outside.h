#pragma once

#include <optional>
#include <string>

#include "src/core/solver.h"

namespace ricochet::outside {

/// The solver that someone brings along: a shared library, "./mine.so", or a program,
/// "python3 mine.py" or "./mine". Nothing where `text` holds neither a / nor a space: then it is
/// the name of one of all_solvers(). Throws InputError where it is no solver.
std::optional<Solver> outside_solver(const std::string& text);

}  // namespace ricochet::outside
