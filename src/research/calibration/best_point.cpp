#include "src/research/calibration/best_point.h"

#include <stdexcept>

#include "ricochet/run.h"

namespace ricochet::studies::calibration {

BestPoint start_of(const Problem& problem) {
  return {problem.start, problem.evaluate(problem.start).objective};
}

void improve(Problem& problem, const Solver& solver, std::int64_t evaluations, BestPoint& best) {
  problem.start = best.x;
  const RunRecord record = run(problem, solver, Budget{evaluations}, 0);
  if (!record.failure.empty()) throw std::runtime_error(problem.name + ": " + record.failure);
  if (record.trace.empty() || record.trace.back().true_values.objective >= best.loss) return;
  best = {record.trace.back().x, record.trace.back().true_values.objective};
}

}  // namespace ricochet::studies::calibration
