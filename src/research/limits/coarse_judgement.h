#pragma once

#include <vector>

#include "src/research/paper/loss.h"

namespace ricochet::studies::limits {

/// Number of parts into which the cells next to a threshold are divided: thresholds are then known
/// to 0.8 %.
inline constexpr int finer = 8;

/// A case with a threshold, and the results of an interpretation for it.
struct CoarseCase {
  carrier_track::Case the_case;
  carrier_track::CoarseScore score;
};

/// The results of an interpretation for C1..C10, and for C11, by coarse cells.
struct CoarseJudgement {
  std::vector<CoarseCase> cases;
  double quiet_share;  ///< of C11, see quiet_share_of_c11()
};

CoarseJudgement judged_coarsely(const carrier_track::Interpretation& interpretation,
                                const carrier_track::Constants& constants);

/// Only the cases with thresholds: C11 is not evaluated, and its share is 0.
CoarseJudgement judged_by_thresholds(const carrier_track::Interpretation& interpretation,
                                     const carrier_track::Constants& constants);

/// Four goals, 0 where the paper's values are reached, and related values.
struct GoalValues {
  double threshold_error;  ///< root mean square of ln(threshold / paper)
  double worst_threshold;  ///< largest |ln|
  int counts_missed;       ///< of 10
  double count_distance;   ///< mean of min(1, |ln((count + 0.3) / (paper + 0.3))|)
  double impurity;         ///< 1 - the lowest purity
  int examples_missed;     ///< of 20
};

GoalValues goals_of(const CoarseJudgement& judgement);

}  // namespace ricochet::studies::limits
