#pragma once

#include <string>
#include <vector>

#include "ricochet/problem.h"

namespace ricochet {

/// 16 hexadecimal digits that depend on every bit of the data behind the problems' scores: boxes,
/// starts, tolerances, weights, best values, and the true values at start and best point.
std::string data_hash(const std::vector<Problem>& problems);

}  // namespace ricochet
