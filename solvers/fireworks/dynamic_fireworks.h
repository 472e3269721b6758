#pragma once

#include <string>

#include "ricochet/solver.h"
#include "solvers/fireworks/population.h"
#include "solvers/fireworks/sparks.h"

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

/// The defaults are the paper's.
struct BareBonesFireworksOptions {
  int sparks = 300;           ///< in each generation
  bool scaled = false;        ///< fewer sparks for a budget below the published: scaled_sparks()
  AmplitudeSteps steps = {};  ///< of the amplitude, which starts at a box width
  Mapping mapping = Mapping::redraw;
  bool neutral_moves = false;  ///< whether the firework also moves to a spark that is as good
};

/// What did best on one half of this suite's problems, see docs/benchmark-method.md.
BareBonesFireworksOptions tuned_options();

/// BBFWA, the bare bones fireworks algorithm (Li and Tan, Applied Soft Computing 62 (2018) 454, doi
/// 10.1016/j.asoc.2017.10.046): one firework, whose sparks are uniform in a box around it. It moves
/// to the best spark (the first one among equals) if that is strictly better, and the amplitude
/// grows; otherwise the amplitude declines. Continues until the evaluator refuses. Throws
/// std::invalid_argument for options out of range.
Solver bare_bones_fireworks(std::string name, const BareBonesFireworksOptions& options = {});

}  // namespace ricochet::fireworks
