#pragma once

#include <optional>

#include "ricochet/problem.h"

namespace ricochet::classic {

/// The Lagrange multipliers of the constraints at the best known point, of length
/// Problem::constraints: at least 0 for inequalities, and 0 for those that are not active. The
/// gradient of the objective plus the constraints' times their multipliers is 0, apart from what
/// the active bounds of the box balance. Where several multipliers do this, these are one choice.
/// Nothing if none do. The problem must have derivatives and a best known point.
std::optional<Vector> multipliers_at_best(const Problem& problem);

}  // namespace ricochet::classic
