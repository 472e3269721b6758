#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "ricochet/random.h"
#include "src/analysis/statistics/hypothesis_tests.h"

namespace ricochet {
namespace {

using testing::DoubleEq;
using testing::ElementsAre;

TEST(Holm, IsAsByHand) {
  // 0.005 * 4, 0.01 * 3, 0.03 * 2, and 0.04 * 1, which may not be less than the one before.
  EXPECT_THAT(holm({0.01, 0.04, 0.03, 0.005}),
              ElementsAre(DoubleEq(0.03), DoubleEq(0.06), DoubleEq(0.06), DoubleEq(0.02)));
  EXPECT_THAT(holm({0.6, 0.7}), ElementsAre(1, 1));
  EXPECT_THAT(holm({}), ElementsAre());
}

/// Closed testing: a hypothesis falls only with every set of hypotheses that it is in, each of
/// which is tested by Bonferroni. That is what Holm's steps abbreviate.
double by_closed_testing(const std::vector<double>& p_values, std::size_t hypothesis) {
  double largest = 0;
  for (unsigned set = 1; set < 1U << p_values.size(); ++set) {
    if ((set >> hypothesis & 1U) == 0) continue;
    double least = 1;
    double members = 0;
    for (std::size_t k = 0; k < p_values.size(); ++k) {
      if ((set >> k & 1U) == 0) continue;
      least = std::min(least, p_values[k]);
      ++members;
    }
    largest = std::max(largest, std::min(1.0, members * least));
  }
  return largest;
}

TEST(Holm, IsClosedTestingWithBonferroni) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    std::vector<double> p_values(1 + random() % 7);
    for (double& p : p_values) p = std::round(20 * uniform(random)) / 100;  // with ties and zeros
    const std::vector<double> adjusted = holm(p_values);
    for (std::size_t k = 0; k < p_values.size(); ++k) {
      EXPECT_DOUBLE_EQ(adjusted[k], by_closed_testing(p_values, k));
    }
  }
}

TEST(Holm, RefusesWhatIsNoProbability) {
  EXPECT_THROW(holm({0.5, 1.5}), std::invalid_argument);
  EXPECT_THROW(holm({std::nan("")}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
