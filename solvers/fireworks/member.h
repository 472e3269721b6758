#pragma once

#include <functional>
#include <string>

#include "ricochet/solver.h"

namespace ricochet::fireworks {

/// A solver of the family, which continues from the start until the evaluator refuses. Takes every
/// problem whose box has room. Points are compared by the feasibility rules, see better().
/// Equalities are accepted too, but once they hold almost no spark keeps them.
Solver member(std::string name,
              std::function<void(Evaluator&, const Vector& start, Random&)> until_refused);

/// Throws std::invalid_argument, with the option's name, for a number outside [1, 10^6].
void check_number(const char* option, int number);

}  // namespace ricochet::fireworks
