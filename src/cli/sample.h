#pragma once

#include <string>

namespace ricochet::cli {

/// Prints a sample of the problems of an archive, evenly over their difficulty, and how far the
/// order of the entries on it agrees with that on all problems. `share` of each family, in (0, 1],
/// but at least three problems.
int sample_problems(const std::string& archive, double share, bool json);

}  // namespace ricochet::cli
