#pragma once

#include <map>
#include <string>

#include "src/core/solver.h"

namespace ricochet::fireworks {

/// The member `of` of the family, but fireworks-as-printed, under another name and with these
/// numbers in place of its own: "fireworks", "sparks" of a generation (of each firework in lotfwa),
/// "gaussian_sparks", "amplitude" in the member's own unit, "guiding_share", and "growth" and
/// "decline" of the amplitude from generation to generation; its version tells them. Throws
/// InputError where there is no such member, where it has no option of a name, and for a value that
/// is out of range.
Solver varied(const std::string& of, const std::string& name,
              const std::map<std::string, double>& options);

}  // namespace ricochet::fireworks
