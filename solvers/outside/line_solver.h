#pragma once

#include <string>

#include "ricochet/solver.h"

namespace ricochet::outside {

/// A solver that is a program exchanging lines of JSON on its standard input and output; the README
/// describes the protocol. `command` is split as a shell does it, but no shell is used. The program
/// is started once for every thread that solves, and serves one start after the other until it ends
/// or the solver is destroyed. State that it keeps between starts may change its results.
///
/// If the program breaks the protocol, or ends before it is done, the run ends with a
/// std::runtime_error that names the line. Throws InputError if the program cannot be started or
/// does not declare itself.
Solver line_solver(const std::string& command);

}  // namespace ricochet::outside
