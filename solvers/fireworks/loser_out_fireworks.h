#pragma once

#include <span>
#include <string>

#include "solvers/fireworks/amplitudes.h"
#include "solvers/fireworks/box.h"
#include "src/core/solver.h"

namespace ricochet::fireworks {

/// The defaults are the paper's.
struct LoserOutFireworksOptions {
  int fireworks = 5;
  int sparks = 60;             ///< of each firework, in each generation, beside the guiding spark
  double guiding_share = 0.2;  ///< of the sparks, at either end, that lead it; in (0, 1]
  AmplitudeSteps steps = {};   ///< of each firework's amplitude, which starts at a box width
  Mapping mapping = Mapping::redraw;
};

/// LoTFWA, the loser-out tournament fireworks algorithm (Li and Tan, IEEE Transactions on
/// Evolutionary Computation 22 (2018) 679, doi 10.1109/TEVC.2017.2787042): every firework lives on
/// in the best of itself, its sparks and its guiding spark, with an amplitude of its own, and one
/// that loses begins anew, uniformly in the box. How many generations are left follows from the
/// budget. Goes on until the evaluator refuses. Throws std::invalid_argument for options that make
/// no sense.
Solver loser_out_fireworks(std::string name, const LoserOutFireworksOptions& options = {});

/// Whether a firework loses: it did get better in the last generation, but so slowly that it would
/// not catch up with the best within those left. `before` and `now` are fitnesses, as fitness_of
/// makes them of all fireworks before and after the generation; `best` is the best of the latter.
bool loses(double before, double now, double best, double generations_left);

}  // namespace ricochet::fireworks
