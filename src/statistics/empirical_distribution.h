#pragma once

#include <vector>

#include "src/statistics/mean_share.h"

namespace ricochet {

/// Share of the pairs of a question and a target that are reached within the time t (evaluations or
/// seconds): the empirical distribution of hitting times, a data profile (Hansen et al. 2021,
/// doi:10.1080/10556788.2020.1808977; Moré and Wild 2009, doi:10.1137/080724083). An entry for each
/// question: the times of its targets, of all runs, infinite where never reached. Every question
/// weighs the same, and the pointwise interval is over questions, since the targets and runs of one
/// question are alike. Throws std::invalid_argument where a question has no times, or one that is
/// no number.
MeanShare empirical_distribution(const std::vector<std::vector<double>>& hitting_times, double t,
                                 double confidence = 0.95);

}  // namespace ricochet
