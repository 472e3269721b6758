#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "src/analysis/statistics/intervals.h"
#include "src/analysis/statistics/running_time.h"

namespace ricochet {

/// ECDF of runtimes (data profile): the share of the pairs of a problem and a target that are
/// reached within the time t, in evaluations or seconds (Hansen et al. 2021,
/// doi:10.1080/10556788.2020.1808977; Moré and Wild 2009, doi:10.1137/080724083). `hitting_times`
/// has an entry for each problem: the times to its targets in all runs, infinite if never reached.
/// Every problem has the same weight, and the pointwise interval is over clusters of problems,
/// because the targets and runs of one problem are alike; see mean_share(). Throws
/// std::invalid_argument if a problem has no times, or a time is no number.
MeanShare empirical_distribution(const std::vector<std::vector<double>>& hitting_times, double t,
                                 const std::vector<std::string>& clusters = {});

/// Performance ratios: each cost over the least cost of any solver for the problem, >= 1. Infinite
/// if the solver failed, even if all others failed too (Dolan and Moré 2002,
/// doi:10.1007/s101070100263, equation 2.1). They depend on the solvers present: a third solver may
/// change which of two is ahead (Gould and Scott 2016, doi:10.1145/2950048). Throws
/// std::invalid_argument for invalid costs.
Costs performance_ratios(const Costs& costs);

/// Performance profile at `ratio`: the share of problems on which this solver's ratio is finite and
/// at most `ratio`. At 1 it is the share of wins,
/// including ties; at infinity the share of problems solved. Throws std::invalid_argument for
/// ratios that are negative or rows of different lengths, or an index without a solver.
double performance_profile(const Costs& ratios, std::size_t solver, double ratio);

}  // namespace ricochet
