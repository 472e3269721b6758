#pragma once

#include <optional>
#include <string>

#include "ricochet/solver.h"

namespace ricochet::outside {

/// Whether the text is a user's solver, which outside_solver() would start: a shared library,
/// "./mine.so", or a program, "python3 mine.py" or "./mine". Otherwise, with neither a / nor a
/// space, it is the name of one of all_solvers(). Throws InputError if it is neither.
bool is_outside(const std::string& text);

/// A user's solver; nothing if `text` is a name. Starts the program, or loads the library in
/// another process, to learn what it claims. Throws InputError if it is no solver.
std::optional<Solver> outside_solver(const std::string& text);

/// As outside_solver(), but starts nothing: the solver is called `text`, accepts every problem and
/// cannot solve any.
std::optional<Solver> unstarted_solver(const std::string& text);

}  // namespace ricochet::outside
