#pragma once

#include <optional>
#include <string>

#include "ricochet/solver.h"

namespace ricochet::outside {

/// A user's solver: a shared library, "./mine.so", or a program, "python3 mine.py" or "./mine".
/// Returns nothing if `text` holds neither a / nor a space: then it is the name of one of
/// all_solvers(). Throws InputError if it is no solver.
std::optional<Solver> outside_solver(const std::string& text);

}  // namespace ricochet::outside
