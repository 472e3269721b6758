#pragma once

#include <span>
#include <string>

#include "ricochet/solver.h"
#include "solvers/fireworks/amplitudes.h"
#include "solvers/fireworks/box.h"

namespace ricochet::fireworks {

/// The defaults are the paper's.
struct LoserOutFireworksOptions {
  int fireworks = 5;
  int sparks = 60;             ///< of each firework, in each generation, besides the guiding spark
  double guiding_share = 0.2;  ///< share at either end that defines the guiding spark; (0, 1]
  AmplitudeSteps steps = {};   ///< of each firework's amplitude, which starts at a box width
  Mapping mapping = Mapping::redraw;
};

/// LoTFWA, the loser-out tournament fireworks algorithm (Li and Tan, IEEE Transactions on
/// Evolutionary Computation 22 (2018) 679, doi 10.1109/TEVC.2017.2787042): every firework is
/// replaced by the best of itself, its sparks and its guiding spark, and has its own amplitude. A
/// firework that loses restarts uniformly in the box. The number of generations left follows from
/// the budget. Continues until the evaluator refuses. Throws std::invalid_argument for options out
/// of range.
Solver loser_out_fireworks(std::string name, const LoserOutFireworksOptions& options = {});

/// Returns true if a firework loses: it improved in the last generation, but so slowly that it
/// would not reach the best one within the generations left. `before` and `now` are fitnesses from
/// fitness_of(), computed over all fireworks before and after the generation; `best` is the best of
/// the latter.
bool loses(double before, double now, double best, double generations_left);

}  // namespace ricochet::fireworks
