#pragma once

#include "src/cli/regimes.h"

namespace ricochet::cli {

/// Prints the borders of a machine over a constant, and draws the map of its regimes. Returns the
/// exit code.
int regime_curves(const RegimesOptions& options);

}  // namespace ricochet::cli
