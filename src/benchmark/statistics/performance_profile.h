#pragma once

#include <cstddef>

#include "src/benchmark/statistics/costs.h"
#include "src/benchmark/statistics/mean_share.h"

namespace ricochet {

/// Performance ratios: each cost over the least cost of any solver for the problem, >= 1. Infinite
/// if the solver failed, even if all others failed too (Dolan and Moré 2002,
/// doi:10.1007/s101070100263, equation 2.1). They depend on the solvers present: a third solver may
/// change which of two is ahead (Gould and Scott 2016, doi:10.1145/2950048), so compare two by the
/// ratios of costs_of_pair(). Throws std::invalid_argument for invalid costs.
Costs performance_ratios(const Costs& costs);

/// Extended performance ratios: each cost over the least cost of the other solvers, so that the
/// ratio of a winner is below 1 and shows its margin (Bussieck, Dirkse and Vigerske 2014, PAVER
/// 2.0, doi:10.1007/s10898-013-0131-5). 0 if it is the only one to solve the problem, infinite if
/// it failed. Throws std::invalid_argument as above, or for a single solver.
Costs extended_performance_ratios(const Costs& costs);

/// Performance profile at `ratio`: the share of problems on which this solver's ratio is finite and
/// at most `ratio`, with its pointwise interval over problems. At 1 it is the share of wins,
/// including ties; at infinity the share of problems solved. Throws std::invalid_argument for
/// ratios that are negative or rows of different lengths, or an index without a solver.
MeanShare performance_profile(const Costs& ratios, std::size_t solver, double ratio,
                              double confidence = 0.95);

}  // namespace ricochet
