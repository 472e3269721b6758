#include "src/benchmark/analysis/reached_by.h"

#include <limits>

namespace ricochet::comparison {

Reached reached_by(const Outcome& outcome, Criterion criterion) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Step> steps = steps_of(outcome, criterion);
  if (steps.empty()) return {infinity, infinity};
  if (outcome.solved(criterion)) {
    return {0, static_cast<double>(evaluations_until_solved(outcome, criterion))};
  }
  return {steps.back().optimality_gap, static_cast<double>(steps.back().evaluations)};
}

}  // namespace ricochet::comparison
