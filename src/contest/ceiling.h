#pragma once

#include <optional>

#include "src/core/question.h"

namespace ricochet::contest {

/// The optimum of a surrogate, judged: how well whoever follows the surrogate to its end can do.
struct Ceiling {
  double optimum;                ///< of the surrogate, in the question's variable
  double distance;               ///< from there to the best point known
  std::optional<double> regret;  ///< nothing where it is truly infeasible
};

/// By a scan of ten of the question's scan steps at a time, and by Brent's method about the best
/// point. Nothing for a question of several variables, or without a surrogate or a best point.
std::optional<Ceiling> ceiling(const Question& question, double width);

}  // namespace ricochet::contest
