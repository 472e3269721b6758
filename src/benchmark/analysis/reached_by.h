#pragma once

#include "src/benchmark/analysis/outcome.h"
#include "src/benchmark/statistics/ranking.h"

namespace ricochet::comparison {

/// What a run is ranked by: the optimality gap of the point that is judged, 0 for all that solve
/// the problem, as accuracy beyond the tolerance does not count; then the evaluations until a point
/// as good was first evaluated. Infinite without a feasible point.
Reached reached_by(const Outcome& outcome, Criterion criterion = Criterion::returned);

}  // namespace ricochet::comparison
