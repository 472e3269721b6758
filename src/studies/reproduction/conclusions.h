#pragma once

#include <string>
#include <vector>

#include "ricochet/scene.h"

namespace ricochet::studies::reproduction {

/// Mean collision count over evenly spaced speeds of 0..18 rad/s, on a grid of restitution,
/// friction and disturbance: the data for testing conclusions A, B and C of the paper.
struct CountGrid {
  std::vector<double> restitutions;
  std::vector<double> frictions;
  std::vector<double> disturbances;  ///< [N]
  std::vector<double> means;         ///< disturbance-major, then friction, then restitution

  double mean(std::size_t restitution, std::size_t friction, std::size_t disturbance) const;
};

/// `step` [rad/s] between the speeds. Parallel over the grid.
CountGrid count_grid(const carrier_track::Scene& interpretation, double step, bool coarse);

/// Neighbours on a line of the grid between which the mean count changes against the claim.
struct Reversal {
  std::string line;           ///< values that are constant along it: "friction 0.1"
  double from, to;            ///< restitution, friction or disturbance [N]
  double mean_from, mean_to;  ///< the mean counts there
};

/// How often neighbours on the grid change as a conclusion says, and the change from end to end.
struct Trend {
  std::string conclusion;  ///< "A", "B" or "C"
  std::string claim;
  int agree = 0;         ///< neighbours that change as claimed
  int disagree = 0;      ///< neighbours that change the other way
  double weakest = 0;    ///< smallest ratio of the grid's end means, larger over smaller as claimed
  double strongest = 0;  ///< largest such ratio
  std::vector<Reversal> exceptions = {};  ///< where neighbours disagree
};

/// A: rises with restitution, without disturbance. B: falls with friction, without disturbance. C:
/// rises with the disturbance, for all other values.
std::vector<Trend> trends(const CountGrid& grid);

}  // namespace ricochet::studies::reproduction
