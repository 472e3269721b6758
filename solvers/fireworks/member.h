#pragma once

#include <functional>
#include <string>

#include "src/core/solver.h"

namespace ricochet::fireworks {

/// A solver of the family, which goes on from the start until the evaluator refuses. Takes every
/// problem with room in its box: points are compared by the rules of feasibility, see better(). So
/// equations are met, too, but then next to nothing moves along them.
Solver member(std::string name,
              std::function<void(Evaluator&, const Vector& start, Random&)> until_refused);

/// Throws std::invalid_argument, with the option's name, for a number that is not in [1, 10^6].
void check_number(const char* option, int number);

}  // namespace ricochet::fireworks
