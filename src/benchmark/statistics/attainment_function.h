#pragma once

#include <vector>

#include "src/statistics/attainment.h"
#include "src/statistics/interval.h"

namespace ricochet {

/// The runs of a solver, by the unit that they belong to: runs of one unit are alike, units are
/// independent. The units are questions or machines, or where there is but one question its runs.
using RunsOfUnits = std::vector<std::vector<History>>;

/// Where an attainment function is asked for: after so many evaluations, at so low a value.
struct AttainmentGrid {
  std::vector<double> evaluations, values;
};

struct Attained {
  double share;
  Interval interval;
};

/// Empirical attainment function on a grid: the share of runs whose best value after t evaluations
/// is z or less, alpha(t, z), every unit weighing the same (Grunert da Fonseca, Fonseca and Hall
/// 2001, doi:10.1007/3-540-44719-9_15; López-Ibáñez et al. 2024, doi:10.1109/TEVC.2024.3462758),
/// with mean_share()'s pointwise interval over units. Entry [i][k] is of the evaluations i and the
/// value k. Throws std::invalid_argument for no units, a unit without runs, or a history that is
/// none.
std::vector<std::vector<Attained>> attainment_function(const RunsOfUnits& runs,
                                                       const AttainmentGrid& grid,
                                                       double confidence = 0.95);

/// alpha_A - alpha_B on the grid, in [-1, 1]: where A leads it is positive (López-Ibáñez, Paquete
/// and Stützle 2010, doi:10.1007/978-3-642-02538-9_9). The units are the same for both, in the same
/// order, and the interval is that of the mean of the differences within units. Throws
/// std::invalid_argument as above, or for unequal numbers of units.
std::vector<std::vector<Attained>> attainment_difference(const RunsOfUnits& a, const RunsOfUnits& b,
                                                         const AttainmentGrid& grid,
                                                         double confidence = 0.95);

}  // namespace ricochet
