#pragma once

#include <span>
#include <string>

#include "ricochet/solver.h"
#include "solvers/fireworks/sparks.h"

namespace ricochet::fireworks {

/// The defaults are the paper's.
struct LoserOutFireworksOptions {
  int fireworks = 5;
  int sparks = 60;             ///< of each firework, in each generation, besides the guiding ones
  double guiding_share = 0.2;  ///< share at either end that defines the guiding spark; (0, 1]
  bool scaled = false;         ///< fewer sparks for a budget below the published: scaled_sparks()
  int guiding_sparks = 1;      ///< of each firework, in each generation
  /// 0: the guiding spark is the firework plus the mean of the best sparks less that of the worst
  /// ones. b > 0: each is the mean of the best sparks plus U(0, b) times that difference.
  double reach = 0;
  AmplitudeSteps steps = {};  ///< of each firework's amplitude, which starts at a box width
  Mapping mapping = Mapping::redraw;
  /// Coordinates outside the box are drawn again within the amplitude about the firework, in place
  /// of `mapping`.
  bool redraw_near = false;
};

/// MGFWA, the multi-guiding spark fireworks algorithm (Meng and Tan, Swarm and Evolutionary
/// Computation 2024, 101458, doi 10.1016/j.swevo.2023.101458): LoTFWA with 10 guiding sparks, which
/// reach 1.5 differences beyond the mean of the best sparks. The equations and the numbers are
/// those of the authors' public program, as are the sparks drawn again near their firework. It
/// leaves open how points rank that are not feasible; here as in all members, see better(). Its
/// count of the generations left ignores the guiding sparks, and an improvement below 1e-8 is none;
/// here both are exact.
LoserOutFireworksOptions multi_guiding_options();

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
