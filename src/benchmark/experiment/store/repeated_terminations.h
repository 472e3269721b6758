#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ricochet/solver.h"

namespace ricochet {

/// A number of consecutive starts that ended for the same reason.
struct RepeatedTermination {
  std::string reason;
  std::int64_t starts = 0;
};

/// Termination reasons without points; equal ones in a row are one entry.
std::vector<RepeatedTermination> repeated(const std::vector<SolverTermination>& terminations);

/// The reverse: one entry for each start.
std::vector<SolverTermination> expanded(const std::vector<RepeatedTermination>& terminations);

}  // namespace ricochet
