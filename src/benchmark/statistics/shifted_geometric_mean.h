#pragma once

#include <vector>

namespace ricochet {

/// exp(mean of log(max(x, floor) + shift)) - shift: a mean of costs in which neither a few long
/// runs nor differences between very short ones have much weight (Achterberg 2007, Constraint
/// Integer Programming, section A.3; shift and floor of PAVER 2.0, doi:10.1007/s10898-013-0131-5,
/// for seconds). Infinite if a cost is; therefore charge a failed run what it spent. Throws
/// std::invalid_argument for no costs, a cost that is negative or no number, or unless shift >= 0
/// and floor >= 0 are finite and not both 0.
double shifted_geometric_mean(const std::vector<double>& costs, double shift = 10,
                              double floor = 1);

}  // namespace ricochet
