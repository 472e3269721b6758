#pragma once

#include <optional>
#include <string>

#include "solvers/fireworks/amplitudes.h"
#include "solvers/fireworks/box.h"
#include "solvers/fireworks/coordinates.h"
#include "solvers/fireworks/selection.h"
#include "solvers/fireworks/spark.h"
#include "solvers/fireworks/spark_counts.h"
#include "src/core/solver.h"

/// The fireworks algorithm that optimised the driver plate's speed, equations (23)-(30) of the
/// paper, which takes it from Tan & Zhu, Fireworks algorithm for optimization, ICSI 2010 (doi
/// 10.1007/978-3-642-13495-1_44), and those that differ from it by options alone.
namespace ricochet::fireworks {

/// What a Gaussian spark does to a firework.
enum class GaussianSpark {
  multiplies,  ///< equation (27)
  approaches,  ///< goes towards the best firework, or away from it, as EFWA has it
};

/// From where to where, in every coordinate.
struct StartRegion {
  double lower, upper;
};

/// The decisions that the papers leave open, or make differently. The defaults read equations (23)
/// to (30) as they are printed, with Tan & Zhu's numbers, for the paper states none. Two decisions
/// are none here: the budget ends a run inside of a generation, for the evaluator refuses (Tan &
/// Zhu's program finishes the generation); and where all distances are 0, the others are drawn
/// uniformly, for (30) is 0 / 0.
struct FireworksOptions {
  int fireworks = 5;  ///< N of (23)
  SparkCountOptions counts = {};
  double amplitude = 40;  ///< A_hat of (25), >= 0, in amplitude_unit
  AmplitudeUnit amplitude_unit = AmplitudeUnit::of_x;
  AmplitudeFloor amplitude_floor = {};  ///< in amplitude_unit; EFWA's check, not in (25)
  Moved moved = Moved::all;             ///< by an explosion
  Offsets offsets = Offsets::each;
  int gaussian_sparks = 5;  ///< in each generation, of fireworks drawn with replacement; >= 0
  Moved gaussian_moved = Moved::all;
  GaussianSpark gaussian_spark = GaussianSpark::multiplies;
  Mapping mapping = Mapping::modulo;
  bool redraw_clones = false;  ///< a spark where its firework is becomes a uniform point instead
  SelectionOptions selection = {};
  /// Where the fireworks begin, as comparisons in the literature have it; without one the first
  /// begins at the start that the solver is given, the others uniformly in the box.
  std::optional<StartRegion> start_region = {};
};

/// The paper's equations: the defaults.
FireworksOptions paper_options();

/// Tan & Zhu's own program: an explosion and a Gaussian spark move ceil(d U(0, 1)) coordinates, and
/// an explosion moves them all by one draw.
FireworksOptions authors_options();

/// What cures the known defects. EFWA's amplitudes, so that the best firework's sparks are no
/// clones of it; EFWA's redraws outside the box and Gaussian sparks, so that no place of the box is
/// favoured; and its uniform selection, for by distance those live on that are far from all that is
/// good. Beyond EFWA at least one coordinate moves; fireworks that are tied have m sparks in all,
/// not 4 m; the best of equals is drawn, so that it drifts along a plateau; and clones are redrawn.
FireworksOptions corrected_options();

/// EFWA, the enhanced fireworks algorithm (Zheng, Janecek and Tan, CEC 2013, doi
/// 10.1109/CEC.2013.6557813). Its amplitude of 40 is 0.2 of the box that it was published for.
FireworksOptions enhanced_options();

/// Sets off fireworks, generation after generation, until the evaluator refuses; asks for nothing
/// then. Throws std::invalid_argument for options that make no sense.
Solver fireworks(std::string name, const FireworksOptions& options);

}  // namespace ricochet::fireworks
