#pragma once

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "problems/carrier_track/gradients/profile_motion.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/problem.h"

/// Problems over a speed that varies in time with a given mean; any number of variables.
namespace ricochet::carrier_track::inline problems {

/// The numbers of knots of the problems, and of some machines' beside them.
inline constexpr std::size_t profile_sizes[] = {2, 4, 8, 16, 32, 64};
inline constexpr std::size_t large_profile_sizes[] = {128, 256};

/// What all profiles of a machine have in common.
struct ProfileFrame {
  double mean;     ///< [rad/s], > 0, of the speed over the window
  double seconds;  ///< [s], > 0, the window, which the knots divide evenly
};

/// The machine's loud_speed as the mean, and the duration of its window at that speed.
inline ProfileFrame profile_frame(const Machine& machine) {
  const double mean = loud_speed(machine);
  const auto* turns = std::get_if<Revolutions>(&machine.scene.window);
  return {mean, turns != nullptr ? 2 * std::numbers::pi * turns->count / mean
                                 : std::get<Seconds>(machine.scene.window).count};
}

/// The scene with a speed profile of this shape, at least two factors > 0: at knot k the speed is
/// mean shape_k / (trapezoidal mean of the shape). It is linear between knots, so the trapezoidal
/// rule is exact: every shape keeps the mean speed, without a constraint. Scaling the shape changes
/// nothing.
template <class Scalar>
BasicScene<Scalar> with_profile(BasicScene<Scalar> scene, const ProfileFrame& frame,
                                std::span<const Scalar> shape) {
  const std::size_t legs = shape.size() - 1;
  Scalar sum = constant<Scalar>(0.5) * (shape.front() + shape.back());
  for (std::size_t k = 1; k < legs; ++k) sum += shape[k];
  const Scalar scale = constant<Scalar>(frame.mean * static_cast<double>(legs)) / sum;
  scene.profile.clear();
  for (std::size_t k = 0; k <= legs; ++k) {
    const double time = frame.seconds * static_cast<double>(k) / static_cast<double>(legs);
    scene.profile.push_back({time, shape[k] * scale});
  }
  scene.window = Seconds{frame.seconds};
  return scene;
}

/// The knots of a scene whose profile has this shape, for derivatives.
ShapedKnots shaped_knots(const Scene& scene, const Vector& shape);

/// Minimise the collision count over the shape of n >= 2 knots, without derivatives. The surrogate
/// has them.
Problem profile_count_problem(const Machine& machine, std::size_t n);

/// Minimise the wear (count.h) over the shape, with derivatives.
Problem profile_wear_problem(const Machine& machine, std::size_t n);

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
