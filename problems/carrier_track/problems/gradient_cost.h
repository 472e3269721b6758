#pragma once

#include <cmath>
#include <cstdint>

namespace ricochet::carrier_track::inline problems {

/// The cost of a gradient of a simulated function beside its value [evaluations], rounded up:
/// Problem::gradient_cost. A pass with up to 16 derivatives takes as long as 3.7 values, a pass
/// with one as long as 1.7. Measured, for 1, 2 to 16, 32 and 64 variables: 0.6 to 0.7, 2.5 to 2.8,
/// 6.3 and 13.5, for every family: `ricochet bench --benchmark_filter=gradient-cost`.
inline std::int64_t gradient_cost(std::int64_t variables) {
  if (variables == 1) return 1;
  const std::int64_t passes = (variables + 15) / 16;
  return static_cast<std::int64_t>(std::ceil(3.7 * static_cast<double>(passes) - 1));
}

/// The same for a risk, whose samples are simulated in lanes if no derivative is needed; measured:
/// 3.2.
inline constexpr std::int64_t robust_gradient_cost = 4;

/// The same for the residuals of calibration, with 5 parameters; measured: 2.0.
inline constexpr std::int64_t calibration_gradient_cost = 3;

}  // namespace ricochet::carrier_track::inline problems
