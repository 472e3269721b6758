#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/core/solver.h"

namespace ricochet {

/// So many starts in a row that ended for the same reason.
struct RepeatedExit {
  std::string reason;
  std::int64_t starts = 0;
};

/// Exits without their points, equal ones in a row as one.
std::vector<RepeatedExit> repeated(const std::vector<SolverExit>& exits);

/// One for each start again.
std::vector<SolverExit> expanded(const std::vector<RepeatedExit>& exits);

}  // namespace ricochet
