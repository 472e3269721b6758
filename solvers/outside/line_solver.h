#pragma once

#include <string>

#include "src/core/solver.h"

namespace ricochet::outside {

/// The solver that a program is which exchanges lines of JSON on its standard input and output; the
/// README says which. `command` is split as a shell does it, but no shell is involved. It is
/// started once for every thread that solves, and serves start after start until it ends, or the
/// solver is no more; so that what it keeps from one to the next may change what it does.
///
/// A run in which the program breaks the protocol, or ends before it is done, ends with a
/// std::runtime_error that names the line. Throws InputError where the program cannot be started or
/// does not say what it is.
Solver line_solver(const std::string& command);

}  // namespace ricochet::outside
