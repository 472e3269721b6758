#pragma once

#include <string>

#include "ricochet/solver.h"
#include "solvers/fireworks/amplitudes.h"
#include "solvers/fireworks/box.h"
#include "solvers/fireworks/coordinates.h"
#include "solvers/fireworks/selection.h"
#include "solvers/fireworks/spark_counts.h"

namespace ricochet::fireworks {

/// The defaults are the paper's.
struct DynamicFireworksOptions {
  int fireworks = 5;
  SparkCountOptions counts = {.sparks = 150};
  double amplitude = 0.2;     ///< A_hat of (25) for all but the best firework, in box widths, >= 0
  AmplitudeSteps steps = {};  ///< of the best firework's amplitude, which starts at a box width
  Moved moved = Moved::coins;
  Mapping mapping = Mapping::redraw;
  bool redraw_clones = false;  ///< as in FireworksOptions
  SelectionOptions selection = {.others = Others::uniform};
};

/// dynFWA, the dynamic search fireworks algorithm (Zheng, Janecek, Li and Tan, CEC 2014, doi
/// 10.1109/CEC.2014.6900485): the amplitude of the best firework grows while its generation finds a
/// strictly better point, and declines otherwise. No Gaussian sparks. Continues until the evaluator
/// refuses. Throws std::invalid_argument for options out of range.
Solver dynamic_fireworks(std::string name, const DynamicFireworksOptions& options = {});

}  // namespace ricochet::fireworks
