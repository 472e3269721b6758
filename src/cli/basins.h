#pragma once

#include "src/cli/regimes.h"

namespace ricochet::cli {

/// Prints which motions sampled starts of a machine lead to, at one speed. Returns the exit code.
int basins(const RegimesOptions& options);

}  // namespace ricochet::cli
