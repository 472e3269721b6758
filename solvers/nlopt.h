#pragma once

#include <nlopt.h>

#include <optional>
#include <vector>

#include "ricochet/solver.h"
#include "solvers/adjustable_solver.h"
#include "solvers/scaled_box.h"

namespace ricochet {

/// An algorithm of NLopt as ricochet runs it, and what NLopt 2.7.1 supports.
struct NloptAlgorithm {
  /// What happens at a point without a finite value. There several local algorithms would report
  /// success or never return, and AGS would read beyond its memory.
  enum class NoNumber {
    ends_the_search,
    is_infinite,
    is_the_worst_so_far,
  };

  const char* name;
  nlopt_algorithm id;
  std::optional<nlopt_algorithm> local = {};  ///< the local algorithm that it starts
  Capabilities capabilities = {};
  NoNumber no_number = NoNumber::ends_the_search;
  bool draws = false;  ///< uses random numbers
  Coordinates coordinates = Coordinates::unit;
  double tolerance = 1e-8;     ///< step [box widths] below which a local search has converged
  double initial_step = 0.25;  ///< of the box; NLopt's own default, without its exceptions
  std::optional<int> population = {};  ///< without: NLopt's own
  int vectors = 100;  ///< kept by quasi-Newton methods; NLopt's own number takes 20 MB

  /// Returns true for the original code of DIRECT, which allocates memory for all points at once.
  bool is_original_direct() const;
};

/// All algorithms that ricochet runs. Left out are StoGO, which ends the process if its local
/// search becomes unstable; NEWUOA, whose version with bounds may never return; PRAXIS, which takes
/// no bounds; augmented Lagrangians around COBYLA and SLSQP, which take all constraints themselves;
/// and near duplicates.
std::vector<NloptAlgorithm> nlopt_algorithms();

/// The solvers of NLopt, "nlopt-...", each with the capabilities it has in NLopt 2.7.1. Those
/// that use gradients, but for MMA and CCSAQ, work in the problem's own coordinates, the others in
/// the unit cube. Local ones begin with a step of a quarter of the box and end at a step of 1e-8 of
/// it; they can then be restarted elsewhere.
///
/// A value that is not finite counts as +infinity or as the worst so far for global solvers, and
/// ends a local one: several local ones would report success or never return.
std::vector<Solver> nlopt_solvers();

/// The adjustable ones. Options: "population" of crs2, isres, esch and mlsl; of local solvers
/// "tolerance" and, if they take it, "initial_step", both as shares of each side of the box, the
/// number of "vectors" that quasi-Newton methods keep, and "coordinates" if runs depend on them.
std::vector<AdjustableSolver> adjustable_nlopt();

}  // namespace ricochet
