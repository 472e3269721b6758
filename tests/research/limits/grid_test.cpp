#include "src/research/limits/grid.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/research/limits/usual_fit.h"

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;

TEST(GridScan, LooksAtEveryCombination) {
  const Fit fit = usual_fit();
  const std::vector<Unknown> axes = {Unknown::counting_limit, Unknown::phase, Unknown::start_share};
  const GridScan scan = scanned_grid(fit, axes, 3);
  double least = 1e9, least_worst = 1e9;
  std::vector<std::vector<double>> map(3, std::vector<double>(3, 1e9));
  for (std::size_t i = 0; i < 27; ++i) {
    Vector u(3);
    u << static_cast<double>(i / 9) / 2, static_cast<double>(i / 3 % 3) / 2,
        static_cast<double>(i % 3) / 2;
    const Parameterisation parameterisation{
        fit.interpretation,
        {Unknown::start_share, Unknown::phase, Unknown::counting_limit},
        fit.constants};
    const GoalValues goals = goals_of(
        judged_by_thresholds(fit.interpretation, constants_at(parameterisation, u.reverse())));
    least = std::min(least, goals.threshold_error);
    least_worst = std::min(least_worst, goals.worst_threshold);
    double& cell = map[i / 9][i / 3 % 3];
    cell = std::min(cell, goals.threshold_error);
  }
  EXPECT_EQ(scan.threshold_error, least);
  EXPECT_EQ(scan.worst_threshold, least_worst);
  EXPECT_EQ(scan.map, map);
  EXPECT_EQ(goals_of(judged_by_thresholds(fit.interpretation, scan.lowest_error.constants))
                .threshold_error,
            least);
  EXPECT_EQ(scan.own_error,
            goals_of(judged_by_thresholds(fit.interpretation, fit.constants)).threshold_error);
}

}  // namespace
}  // namespace ricochet::studies::limits
