#pragma once

#include <vector>

#include "src/core/vector.h"

namespace ricochet::fireworks {

/// What equation (24) gives where a firework's share of sparks is within its limits.
enum class ThirdBranch {
  rounded_share,  ///< round(S_i), as Tan & Zhu have it
  as_printed,     ///< round(a m), as the paper prints it: the fewest, whatever the share
};

/// What fireworks get that are all of the same fitness.
enum class TiedShare {
  most,   ///< each the most, as (23) has it: 200 sparks of 5 fireworks, where others get about 50
  equal,  ///< each the same part of m
};

struct SparkCountOptions {
  double sparks = 50;    ///< m of (23): what the fireworks share
  double fewest = 0.04;  ///< a of (24): no firework has fewer than round(a m) sparks, which is >= 1
  double most = 0.8;     ///< b of (24): and none more than round(b m); a < b < 1
  double epsilon =
      2.2e-16;  ///< of (23), in the units of the objective; the papers only call it small
  ThirdBranch third_branch = ThirdBranch::rounded_share;
  TiedShare tied = TiedShare::most;
};

/// Equations (23) and (24): how many sparks each firework gets, by the fitness of all, finite and
/// better where lower.
std::vector<int> spark_counts(const Vector& fitness, const SparkCountOptions& options);

/// So many sparks n fireworks have at most, in all.
int most_sparks(int fireworks, const SparkCountOptions& options);

/// Throws std::invalid_argument for options under which a firework may have no spark, or that do
/// not fit together.
void check(const SparkCountOptions& options);

}  // namespace ricochet::fireworks
