#pragma once

#include "problems/classic/formula.h"

namespace ricochet::classic {

/// The statement of "classic-<name>-<n>", for a function that is nonnegative on R^n and 0 at
/// `best`, on [lower, upper]^n.
Statement nonnegative(const char* name, const char* source, double lower, double upper,
                      Vector best);

}  // namespace ricochet::classic
