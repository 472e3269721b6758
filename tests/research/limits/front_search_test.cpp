#include "src/research/limits/front_search.h"

#include <gtest/gtest.h>

#include "tests/research/limits/usual_fit.h"

namespace ricochet::studies::limits {
namespace {

using namespace carrier_track;

FrontChain short_chain(int seed) {
  const std::vector<Unknown> few = {Unknown::counting_limit, Unknown::start_velocity};
  const std::vector<Unknown> more = {Unknown::counting_limit, Unknown::start_velocity,
                                     Unknown::phase};
  return {usual_fit().interpretation, {few, more}, seed, 12, 3};
}

TEST(FrontSearch, FindsFrontsOfMoreAndMoreConstants) {
  FitStore store(no_file_yet());
  const auto fronts = searched_fronts({short_chain(1), short_chain(2)}, store);
  ASSERT_EQ(fronts.size(), 4U);
  EXPECT_EQ(fronts[0].parameterisation.free.size(), 2U);
  EXPECT_EQ(fronts[1].parameterisation.free.size(), 3U);
  EXPECT_EQ(fronts[2].seed, 2);
  for (const ChainedFront& front : fronts) {
    ASSERT_FALSE(front.fits.empty());
    ASSERT_EQ(front.fits.size(), front.goals.size());
    for (std::size_t i = 0; i < front.fits.size(); ++i) {
      EXPECT_EQ(front.fits[i].loss, front.goals[i].threshold_error);
      for (const GoalValues& other : front.goals) {
        EXPECT_FALSE(dominates(goal_vector(other), goal_vector(front.goals[i])));
      }
    }
    EXPECT_GE(front.dominated_share(), 0);
    EXPECT_LT(front.dominated_share(), 1);
  }
}

TEST(FrontSearch, GoesOnFromTheStoreToTheSameBits) {
  const auto file = no_file_yet();
  FitStore store(file);
  const auto found = searched_fronts({short_chain(1)}, store);
  const auto written = std::filesystem::last_write_time(file);
  FitStore again(file);
  const auto known = searched_fronts({short_chain(1)}, again);
  EXPECT_EQ(std::filesystem::last_write_time(file), written);
  ASSERT_EQ(known.size(), found.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    ASSERT_EQ(known[k].fits.size(), found[k].fits.size());
    for (std::size_t i = 0; i < found[k].fits.size(); ++i) {
      EXPECT_EQ(known[k].fits[i].constants, found[k].fits[i].constants);
    }
    EXPECT_EQ(known[k].dominated_share(), found[k].dominated_share());
  }
}

TEST(FrontSearch, DominatesMoreTheNearerItComes) {
  ChainedFront front;
  front.goals = {{0.15, 0.2, 5, 0.0, 0.5, 5}};
  EXPECT_DOUBLE_EQ(front.dominated_share(), 1.0 / 16);
  front.goals.push_back({0.0, 0, 0, 0.0, 0.0, 0});
  EXPECT_DOUBLE_EQ(front.dominated_share(), 1);
}

}  // namespace
}  // namespace ricochet::studies::limits
