#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ricochet/solver.h"
#include "solvers/adjustable_solver.h"
#include "solvers/fireworks/population.h"
#include "solvers/fireworks/sparks.h"

/// The fireworks algorithm that optimised the driver plate's speed, equations (23)-(30) of the
/// paper, which takes it from Tan & Zhu, Fireworks algorithm for optimization, ICSI 2010 (doi
/// 10.1007/978-3-642-13495-1_44), and the variants that differ from it by options only.
namespace ricochet::fireworks {

/// How a Gaussian spark is made from a firework.
enum class GaussianSpark {
  multiplies,  ///< equation (27)
  approaches,  ///< moves towards the best firework, or away from it, as in EFWA
};

/// The same bounds for every coordinate.
struct StartRegion {
  double lower, upper;
};

/// The decisions that the papers leave open or make differently. The defaults follow equations (23)
/// to (30) as printed, with the numbers of Tan & Zhu, because the paper states none. Two decisions
/// are not options: the budget ends a run within a generation, because the evaluator refuses (the
/// program of Tan & Zhu finishes the generation); and if all distances are 0, so that (30) is 0 /
/// 0, the others are drawn uniformly.
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
  bool redraw_clones = false;  ///< a spark at its firework's place is replaced by a uniform point
  SelectionOptions selection = {};
  /// The region where the fireworks begin, as in comparisons in the literature. Without it the
  /// first firework begins at the start given to the solver, the others uniformly in the box.
  std::optional<StartRegion> start_region = {};
};

/// The paper's equations: the defaults.
FireworksOptions paper_options();

/// The program of Tan & Zhu: an explosion and a Gaussian spark move ceil(d U(0, 1)) coordinates,
/// and an explosion moves all of these by the same draw.
FireworksOptions authors_options();

/// Corrects the known defects. From EFWA: amplitudes, so that the sparks of the best firework are
/// not clones of it; redraws outside the box and Gaussian sparks, so that no part of the box is
/// favoured; and uniform selection, because selection by distance keeps points far from all good
/// ones. Beyond EFWA: at least one coordinate moves; tied fireworks have m sparks in all, not 4 m;
/// the best of equals is drawn, so that it drifts along a plateau; and clones are redrawn.
FireworksOptions corrected_options();

/// EFWA, the enhanced fireworks algorithm (Zheng, Janecek and Tan, CEC 2013, doi
/// 10.1109/CEC.2013.6557813). Its amplitude of 40 is 0.2 of the box that it was published for.
FireworksOptions enhanced_options();

/// Generates fireworks and sparks, generation after generation, until the evaluator refuses, and
/// asks for nothing after that. Throws std::invalid_argument for options out of range.
Solver fireworks(std::string name, const FireworksOptions& options);

/// The members of the family except fireworks-as-printed. Options: "fireworks"; "sparks" of a
/// generation (of each firework in lotfwa, mgfwa and fwassp); "gaussian_sparks"; "amplitude" in the
/// member's own unit; "guiding_share" and "guiding_sparks"; "growth" and "decline" of the amplitude
/// from generation to generation; and "initial_scale" in box widths and "patience" of fwassp.
std::vector<AdjustableSolver> adjustable_family();

/// Every member of the family, as published or, for "corrected", with the known defects removed.
/// "as-printed" follows the third branch of equation (24) as the paper prints it.
std::vector<Solver> family();

}  // namespace ricochet::fireworks
