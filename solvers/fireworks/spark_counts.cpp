#include "solvers/fireworks/spark_counts.h"

#include <cmath>
#include <stdexcept>

namespace ricochet::fireworks {

std::vector<int> spark_counts(const Vector& fitness, const SparkCountOptions& options) {
  const double worst = fitness.maxCoeff();
  const double excess = (worst - fitness.array()).sum();
  const double fewest = options.fewest * options.sparks;
  const double most = options.most * options.sparks;
  std::vector<int> counts;
  counts.reserve(static_cast<std::size_t>(fitness.size()));
  for (const double f : fitness) {
    double share = options.sparks * (worst - f + options.epsilon) / (excess + options.epsilon);
    if (excess == 0 && options.tied == TiedShare::equal) {
      share = options.sparks / static_cast<double>(fitness.size());
    }
    if (share > most) {
      share = most;
    } else if (share < fewest || options.third_branch == ThirdBranch::as_printed) {
      share = fewest;
    }
    counts.push_back(static_cast<int>(std::round(share)));
  }
  return counts;
}

int most_sparks(int fireworks, const SparkCountOptions& options) {
  return fireworks * static_cast<int>(std::round(options.most * options.sparks));
}

void check(const SparkCountOptions& options) {
  const bool ordered = options.fewest < options.most && options.most < 1;
  if (!ordered || !(options.fewest * options.sparks >= 0.5) || !(options.sparks <= 1e6)) {
    throw std::invalid_argument(
        "sparks: needs fewest < most < 1, fewest * sparks >= 0.5 and sparks <= 1e6");
  }
  if (!(options.epsilon > 0)) throw std::invalid_argument("epsilon: must be > 0");
}

}  // namespace ricochet::fireworks
