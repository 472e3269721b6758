#pragma once

#include <cstddef>
#include <vector>

namespace ricochet {

/// The cost (evaluations or seconds, > 0) of every solver to solve a problem: a row for each
/// problem, an entry for each solver. Infinite if the solver did not solve it.
using Costs = std::vector<std::vector<double>>;

/// Returns the number of solvers. Throws std::invalid_argument if there is no problem or no solver,
/// rows differ in length, or a cost is not positive.
std::size_t check_costs(const Costs& costs);

/// The costs of two solvers only. Throws std::invalid_argument as above, or for an index without a
/// solver.
Costs costs_of_pair(const Costs& costs, std::size_t a, std::size_t b);

}  // namespace ricochet
