#include <gtest/gtest.h>

#include <algorithm>

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/machine.h"
#include "src/studies/surrogate/study.h"

namespace ricochet::studies::surrogate {
namespace {

const BiasStudy& study() {
  static const BiasStudy made = study_bias({0.25, {1.0, 1e-7}});
  return made;
}

TEST(Bias, KnowsTheBestOfTheCountFromAScan) {
  const auto machines = carrier_track::all_machines();
  ASSERT_EQ(study().cases.size(), machines.size());
  for (std::size_t c = 0; c < machines.size(); ++c) {
    const auto scan = carrier_track::scan_speeds(machines[c].scene, 0.25, 18);
    EXPECT_EQ(study().cases[c].lowest, *std::min_element(scan.counts.begin(), scan.counts.end()));
    std::size_t last = scan.counts.size() - 1;
    while (scan.counts[last] > machines[c].quiet_limit) --last;
    EXPECT_EQ(study().cases[c].fastest, scan.omega(last)) << machines[c].id;
  }
}

TEST(Bias, ClosesAsTheSmoothingGoesToZero) {
  for (const CaseBias& row : study().cases) {
    const Bias& closed = row.biases[1];
    EXPECT_LT(closed.error, 1e-9) << row.id;
    EXPECT_GT(closed.rank_correlation.value(), 0.999) << row.id;
    EXPECT_EQ(closed.count_optimality_gap, 0) << row.id;
    EXPECT_EQ(closed.speed_optimality_gap, 0.0) << row.id;
    EXPECT_FALSE(closed.loud) << row.id;
  }
}

TEST(Bias, IsOpenWhereTheSurrogateIsWide) {
  for (const CaseBias& row : study().cases) EXPECT_GT(row.biases[0].error, 0.1) << row.id;
}

}  // namespace
}  // namespace ricochet::studies::surrogate
