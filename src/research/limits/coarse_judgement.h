#pragma once

#include <vector>

#include "problems/carrier_track/questions/misfit.h"

namespace ricochet::studies::limits {

/// So finely the cells next to a threshold are looked at again: thresholds are then known to 0.8 %.
inline constexpr int finer = 8;

/// A case with a threshold, and how a reading does there.
struct CoarseCase {
  carrier_track::Case the_case;
  carrier_track::CoarseScore score;
};

/// How a reading does in C1..C10, and in C11, by coarse cells.
struct CoarseJudgement {
  std::vector<CoarseCase> cases;
  double quiet_share;  ///< of C11, see quiet_share_of_c11()
};

CoarseJudgement judged_coarsely(const carrier_track::Reading& reading,
                                const carrier_track::Constants& constants);

/// The cases alone: C11 is not looked at, and its share is 0.
CoarseJudgement judged_by_thresholds(const carrier_track::Reading& reading,
                                     const carrier_track::Constants& constants);

/// Four goals, 0 where the paper is reached, and beside them what is told.
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
