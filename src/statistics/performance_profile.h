#pragma once

#include <cstddef>

#include "src/statistics/costs.h"
#include "src/statistics/mean_share.h"

namespace ricochet {

/// Performance ratios: each cost over the least that any solver paid for the question, >= 1.
/// Infinite where the solver failed, whoever else did (Dolan and Moré 2002,
/// doi:10.1007/s101070100263, equation 2.1). They depend on the solvers present: which of two is
/// ahead may change with a third (Gould and Scott 2016, doi:10.1145/2950048), so that two are to be
/// compared by the ratios of costs_of_pair(). Throws std::invalid_argument for costs that are none.
Costs performance_ratios(const Costs& costs);

/// Extended performance ratios: each cost over the least of the others', so that those of a winner
/// are below 1 and say by how much it won (Bussieck, Dirkse and Vigerske 2014, PAVER 2.0,
/// doi:10.1007/s10898-013-0131-5). 0 where it alone solved the question, infinite where it failed.
/// Throws std::invalid_argument as above, or for one solver alone.
Costs extended_performance_ratios(const Costs& costs);

/// Performance profile at `ratio`: the share of questions on which this solver's ratio is finite
/// and no larger, with its pointwise interval over questions. At 1 it is the share of wins, ties
/// among them; at infinity that of questions solved. Throws std::invalid_argument for ratios that
/// are negative or of unequal number, or a solver that is not there.
MeanShare performance_profile(const Costs& ratios, std::size_t solver, double ratio,
                              double confidence = 0.95);

}  // namespace ricochet
