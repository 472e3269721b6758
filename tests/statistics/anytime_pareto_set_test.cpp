#include "src/statistics/anytime_pareto_set.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace ricochet {
namespace {

using Places = std::vector<std::size_t>;

TEST(AnytimeParetoSet, DropsOnlyWhomOneRivalBeatsEverywhere) {
  const std::vector<std::vector<double>> values = {
      {5, 3, 1},  // slow, best at the end
      {1, 2, 4},  // fast
      {6, 4, 2},  // behind the first everywhere
      {2, 3, 5},  // behind the second everywhere
      {3, 3, 3},  // beaten everywhere, but each time by another
      {5, 3, 1},  // as the first: level is not beaten
  };
  EXPECT_EQ(anytime_pareto_set(values), (Places{0, 1, 4, 5}));
  EXPECT_TRUE(anytime_pareto_set({}).empty());
  EXPECT_EQ(anytime_pareto_set({{2, 2}, {1, 2}}), (Places{0, 1}));  // level once is enough
}

TEST(AnytimeParetoSet, RefusesWhatDoesNotFit) {
  EXPECT_THROW(anytime_pareto_set({{}}), std::invalid_argument);
  EXPECT_THROW(anytime_pareto_set({{1, 2}, {1}}), std::invalid_argument);
  EXPECT_THROW(anytime_pareto_set({{std::nan("")}}), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet
