#include "solvers/golden_section.h"

#include <numbers>

#include "solvers/unit_box.h"

namespace ricochet {

Solver golden_section() {
  constexpr double step_tolerance = 1e-8;  // of the box
  constexpr double section = 2 - std::numbers::phi;
  Solver solver;
  solver.name = "golden-section";
  solver.version = "ricochet " RICOCHET_VERSION;
  solver.capabilities.most_variables = 1;
  solver.solve = [](Evaluator& evaluator, const Vector& start, Random&) -> SolverTermination {
    double a = evaluator.lower()[0], x = start[0], b = evaluator.upper()[0];
    const double width = b - a;
    auto best = evaluator.objective(start);
    while (best && b - a > step_tolerance * width) {
      const double y = b - x > x - a ? x + section * (b - x) : x - section * (x - a);
      const auto there = evaluator.objective(Vector::Constant(1, y));
      if (!there) break;
      const bool better = *there < *best;
      (better == (y > x) ? a : b) = better ? x : y;
      if (better) {
        x = y;
        best = there;
      }
    }
    return {evaluator.over() ? stopped_by_evaluator : "the interval is short",
            Vector::Constant(1, x)};
  };
  return solver;
}

}  // namespace ricochet
