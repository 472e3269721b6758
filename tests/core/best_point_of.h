#pragma once

#include <stdexcept>

#include "ricochet/evaluator.h"
#include "src/core/instance.h"

namespace ricochet {

/// The best point of the instance, 0 to 20, whose box the evaluator has: for a solver that knows
/// the problem from elsewhere, since the evaluator does not tell.
inline Vector best_point_of(const Problem& problem, const Evaluator& evaluator) {
  for (int k = 0; k <= 20; ++k) {
    const Problem known = instance(problem, k);
    if (known.lower == evaluator.lower() && known.upper == evaluator.upper()) {
      return known.best_point.value();
    }
  }
  throw std::logic_error(problem.name + ": no instance has this box");
}

}  // namespace ricochet
