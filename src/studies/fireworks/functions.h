#pragma once

#include <string>

#include "ricochet/problem.h"
#include "src/report/json.h"

namespace ricochet::studies::fireworks {

/// Returns one of the nine functions on which the algorithm was published, by its name in Table 3,
/// on [-100, 100]^n; its best value is 0. Schwefel is sum (x_1 - x_i^2)^2 + (x_i - 1)^2; Ellipse,
/// Cigar and Tablet have the factor 10^4. Throws std::out_of_range for another name.
Problem benchmark_function(const std::string& name, Eigen::Index n);

/// Sum (x_i - shift)^2 on [-100, 100]^n.
Problem shifted_sphere(double shift, Eigen::Index n);

/// Error of every member of the family on Sphere, in 30 dimensions with 10,000 evaluations, over
/// the distance of the optimum from the origin.
report::Json shift_data(int runs);

}  // namespace ricochet::studies::fireworks
