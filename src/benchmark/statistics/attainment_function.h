#pragma once

#include <vector>

#include "src/benchmark/statistics/attainment.h"
#include "src/benchmark/statistics/interval.h"

namespace ricochet {

/// The runs of a solver, by unit: runs of one unit are alike, units are independent. The units are
/// problems or machines; if there is only one problem, its runs.
using RunsOfUnits = std::vector<std::vector<History>>;

/// The grid of an attainment function: numbers of evaluations and values.
struct AttainmentGrid {
  std::vector<double> evaluations, values;
};

struct Attained {
  double share;
  Interval interval;
};

/// Empirical attainment function on a grid: alpha(t, z) is the share of runs whose best value after
/// t evaluations is z or less, every unit having the same weight (Grunert da Fonseca, Fonseca and
/// Hall 2001, doi:10.1007/3-540-44719-9_15; López-Ibáñez et al. 2024,
/// doi:10.1109/TEVC.2024.3462758), with the pointwise interval of mean_share() over units. Entry
/// [i][k] is for the i-th number of evaluations and the k-th value. Throws std::invalid_argument
/// for no units, a unit without runs, or an invalid history.
std::vector<std::vector<Attained>> attainment_function(const RunsOfUnits& runs,
                                                       const AttainmentGrid& grid,
                                                       double confidence = 0.95);

/// alpha_A - alpha_B on the grid, in [-1, 1]: positive where A leads (López-Ibáñez, Paquete and
/// Stützle 2010, doi:10.1007/978-3-642-02538-9_9). Both have the same units in the same order, and
/// the interval is that of the mean of the differences within units. Throws std::invalid_argument
/// as above, or for different numbers of units.
std::vector<std::vector<Attained>> attainment_difference(const RunsOfUnits& a, const RunsOfUnits& b,
                                                         const AttainmentGrid& grid,
                                                         double confidence = 0.95);

}  // namespace ricochet
