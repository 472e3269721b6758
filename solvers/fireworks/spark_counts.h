#pragma once

#include <vector>

#include "ricochet/vector.h"

namespace ricochet::fireworks {

/// The value of equation (24) if a firework's share of sparks is within its limits.
enum class ThirdBranch {
  rounded_share,  ///< round(S_i), as in Tan & Zhu
  as_printed,     ///< round(a m), as the paper prints it: the fewest, whatever the share
};

/// The spark counts of fireworks that all have the same fitness.
enum class TiedShare {
  most,   ///< each the most, as in (23): 200 sparks of 5 fireworks, others get about 50
  equal,  ///< each the same part of m
};

struct SparkCountOptions {
  double sparks = 50;    ///< m of (23): the total that the fireworks share
  double fewest = 0.04;  ///< a of (24): no firework has fewer than round(a m) sparks, which is >= 1
  double most = 0.8;     ///< b of (24): and none more than round(b m); a < b < 1
  double epsilon =
      2.2e-16;  ///< of (23), in the unit of the objective; the papers only call it small
  ThirdBranch third_branch = ThirdBranch::rounded_share;
  TiedShare tied = TiedShare::most;
};

/// Equations (23) and (24): the number of sparks of each firework. `fitness` holds a finite number
/// for each, lower is better.
std::vector<int> spark_counts(const Vector& fitness, const SparkCountOptions& options);

/// The largest possible number of sparks of n fireworks in all.
int most_sparks(int fireworks, const SparkCountOptions& options);

/// Throws std::invalid_argument for options that contradict each other or allow a firework without
/// sparks.
void check(const SparkCountOptions& options);

}  // namespace ricochet::fireworks
