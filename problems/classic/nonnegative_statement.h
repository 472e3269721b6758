#pragma once

#include "problems/classic/formula.h"

namespace ricochet::classic {

/// Of a function on [lower, upper]^n that is nowhere negative on R^n, and 0 at `best`: the problem
/// "classic-<name>-<n>".
Statement nonnegative(const char* name, const char* source, double lower, double upper,
                      Vector best);

}  // namespace ricochet::classic
