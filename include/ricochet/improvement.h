#pragma once

#include <cstdint>

#include "ricochet/problem.h"

namespace ricochet {

/// A point whose true objective was better than that of every earlier one.
struct Improvement {
  std::int64_t evaluations;  ///< charged up to its evaluation
  double seconds;
  TrueValues true_values;
  Vector x;
};

}  // namespace ricochet
