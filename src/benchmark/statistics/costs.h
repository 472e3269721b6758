#pragma once

#include <cstddef>
#include <vector>

namespace ricochet {

/// What every solver spent (evaluations or seconds, > 0) until it solved a question: a row for each
/// question, an entry for each solver. Infinite where it did not solve it.
using Costs = std::vector<std::vector<double>>;

/// The number of solvers. Throws std::invalid_argument where there is no question or no solver, a
/// row is longer than another, or a cost is not positive.
std::size_t check_costs(const Costs& costs);

/// The same of two solvers alone. Throws std::invalid_argument as above, or for a solver that is
/// not there.
Costs costs_of_pair(const Costs& costs, std::size_t a, std::size_t b);

}  // namespace ricochet
