#pragma once

#include <vector>

#include "src/benchmark/statistics/mean_share.h"

namespace ricochet {

/// ECDF of runtimes (data profile): the share of the pairs of a problem and a target that are
/// reached within the time t, in evaluations or seconds (Hansen et al. 2021,
/// doi:10.1080/10556788.2020.1808977; Moré and Wild 2009, doi:10.1137/080724083). `hitting_times`
/// has an entry for each problem: the times to its targets in all runs, infinite if never reached.
/// Every problem has the same weight, and the pointwise interval is over problems, because the
/// targets and runs of one problem are alike. Throws std::invalid_argument if a problem has no
/// times, or a time is no number.
MeanShare empirical_distribution(const std::vector<std::vector<double>>& hitting_times, double t,
                                 double confidence = 0.95);

}  // namespace ricochet
