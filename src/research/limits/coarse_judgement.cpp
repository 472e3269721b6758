#include "src/research/limits/coarse_judgement.h"

#include <algorithm>
#include <cmath>

namespace ricochet::studies::limits {

using namespace carrier_track;

CoarseJudgement judged_by_thresholds(const Interpretation& interpretation,
                                     const Constants& constants) {
  CoarseJudgement judgement{{}, 0};
  for (const Case& a_case : all_cases()) {
    if (!a_case.claim.threshold) continue;
    judgement.cases.push_back({a_case, coarse_score(interpretation, constants, a_case, finer)});
  }
  return judgement;
}

CoarseJudgement judged_coarsely(const Interpretation& interpretation, const Constants& constants) {
  CoarseJudgement judgement = judged_by_thresholds(interpretation, constants);
  for (const CoarseCase& c : judgement.cases) {
    if (c.the_case.id != "C4") continue;
    judgement.quiet_share =
        quiet_share_of_c11(interpretation, constants, std::max(c.score.quiet_count, 1));
  }
  return judgement;
}

GoalValues goals_of(const CoarseJudgement& judgement) {
  GoalValues goals{};
  const auto size = static_cast<double>(judgement.cases.size());
  double squares = 0;
  for (const CoarseCase& c : judgement.cases) {
    const Claim& claim = c.the_case.claim;
    const double error = std::log(c.score.threshold / *claim.threshold);
    squares += error * error;
    goals.worst_threshold = std::max(goals.worst_threshold, std::abs(error));
    const double count = std::log((c.score.quiet_count + 0.3) / (*claim.quiet_count + 0.3));
    goals.counts_missed += c.score.quiet_count == *claim.quiet_count ? 0 : 1;
    goals.count_distance += std::min(1.0, std::abs(count)) / size;
    goals.impurity = std::max(goals.impurity, 1 - c.score.purity);
    goals.examples_missed += c.score.wrong_examples;
  }
  goals.threshold_error = std::sqrt(squares / size);
  return goals;
}

}  // namespace ricochet::studies::limits
