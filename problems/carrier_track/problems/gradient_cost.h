#pragma once

#include <cstdint>

namespace ricochet::carrier_track::inline problems {

/// The cost of a gradient by dual numbers beside the value [evaluations], rounded up:
/// Problem::gradient_cost. Measured, for 1 and 5 variables: 0.6 to 0.7 and 2.5 to 2.8, for every
/// family: `ricochet bench --benchmark_filter=gradient-cost`.
inline std::int64_t gradient_cost(std::int64_t variables) {
  return variables == 1 ? 1 : 3;
}

/// The same for the shape of a speed profile, by the adjoint method; measured, for 2 to 256 knots:
/// 0.8 to 1.3.
inline constexpr std::int64_t profile_gradient_cost = 2;

/// The same for a risk, whose samples are simulated in lanes if no derivative is needed; measured:
/// 3.2.
inline constexpr std::int64_t robust_gradient_cost = 4;

/// The same for the residuals of calibration, with 5 parameters; measured: 2.0.
inline constexpr std::int64_t calibration_gradient_cost = 3;

}  // namespace ricochet::carrier_track::inline problems
