#pragma once

#include "ricochet/solver.h"
#include "src/report/json.h"

namespace ricochet::studies {

/// The name and the version of a solver.
inline report::Json solver_data(const Solver& solver) {
  return {{"name", solver.name}, {"version", solver.version}};
}

}  // namespace ricochet::studies
