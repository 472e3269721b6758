#pragma once

#include <vector>

#include "problems/carrier_track/cases.h"
#include "problems/carrier_track/threshold.h"
#include "src/core/problem.h"

/// The questions put to solvers, all from the one objective of collisions.h. The variable is the
/// speed of the driver plate [rad/s] in [slowest_speed, fastest_speed].
namespace ricochet::carrier_track {

/// The paper's range is 0..18 rad/s; at 0 a window of revolutions would never end.
inline constexpr double slowest_speed = 0.01;
inline constexpr double fastest_speed = 18.0;

/// Minimise the collision count: an integer staircase, no derivatives.
Problem count_problem(const Case& a_case, const Scene& reading);

/// Minimise the smooth surrogate, with derivatives; judged by the true count.
Problem surrogate_problem(const Case& a_case, const Scene& reading, double width);

/// The fastest quiet speed: minimise -omega subject to count <= limit. No derivatives.
Problem top_speed_problem(const Case& a_case, const Scene& reading, double limit);

/// The same with the surrogate, and derivatives, in the constraint; judged by the true count.
Problem top_speed_surrogate_problem(const Case& a_case, const Scene& reading, double limit,
                                    double width);

/// All four for one case.
std::vector<Problem> problems_of(const Case& a_case, const Scene& reading);

/// Sets the best known values from an exhaustive scan of the case's speeds, from slowest_speed on:
/// the lowest count, and the fastest speed within the quiet limit.
void certify(std::vector<Problem>& problems, const SpeedScan& scan, double limit);

}  // namespace ricochet::carrier_track
