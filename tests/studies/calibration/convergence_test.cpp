#include "src/studies/calibration/convergence.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "src/studies/paper/loss.h"
#include "tests/studies/calibration/some_search.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

/// What searches ended with that nobody made: three looks each.
Convergence told_convergence(const std::vector<std::vector<double>>& losses) {
  Convergence one;
  for (const auto& looks : losses) {
    LongSearch& search = one.searches.emplace_back();
    search.solver = "told";
    for (const double loss : looks) {
      search.fits.push_back({Interpretation{}, {}, natural_constants(), loss, {}});
    }
  }
  return one;
}

TEST(Convergence, IsWhereTheWorstSearchIsNearTheBest) {
  const Convergence one = told_convergence({{30, 20.1, 20}, {50, 20.1, 20.1}});
  EXPECT_EQ(one.best().loss, 20);
  EXPECT_DOUBLE_EQ(one.spread(0), 1.5);
  EXPECT_DOUBLE_EQ(one.spread(1), 20.1 / 20 - 1);
  EXPECT_EQ(one.agreed_from(), 0.5);
  EXPECT_EQ(one.as_good().size(), 2U);
  EXPECT_EQ(told_convergence({{20, 20, 20}, {20, 20, 20.3}}).as_good().size(), 1U);
  EXPECT_EQ(told_convergence({{20, 20, 20}, {20, 20, 20}}).agreed_from(), 0.25);
  EXPECT_FALSE(told_convergence({{20, 20, 20}, {20, 20, 20.3}}).agreed_from());
}

TEST(Convergence, KnowsWhichPairsComeInOneOrder) {
  const OrderOfPairs order = order_of_pairs({told_convergence({{9, 9, 1}, {9, 9, 2}}),
                                             told_convergence({{9, 9, 3}, {9, 9, 3}}),
                                             told_convergence({{9, 9, 2}, {9, 9, 4}})});
  EXPECT_EQ(order.all, 3);
  ASSERT_EQ(order.ties.size(), 1U);
  EXPECT_EQ(order.ties[0], std::make_pair(std::size_t{1}, std::size_t{2}));
}

TEST(Convergence, SearchesFromEverySeedAndGoesOnFromTheStore) {
  const auto file = std::filesystem::path(testing::TempDir()) /
                    ("convergence_" + std::to_string(getpid()) + ".toml");
  std::filesystem::remove(file);
  FitStore store(file);
  Parameterisation parameterisation = some_parameterisation();
  parameterisation.held[static_cast<std::size_t>(Unknown::counting_limit)] = 0.1;
  const ConvergencePlan plan{{some_search(1).global}, {1, 2}, 24};
  const auto all = converge({parameterisation}, plan, store);
  ASSERT_EQ(all.size(), 1U);
  ASSERT_EQ(all[0].searches.size(), 2U);
  for (const LongSearch& search : all[0].searches) {
    EXPECT_EQ(search.solver, "nlopt-crs2");
    ASSERT_EQ(search.fits.size(), std::size(looked_at));
    for (std::size_t k = 0; k < search.fits.size(); ++k) {
      const Fit& fit = search.fits[k];
      EXPECT_DOUBLE_EQ(fit.loss, loss(fit.interpretation, fit.constants));
      if (k > 0) {
        EXPECT_LE(fit.loss, search.fits[k - 1].loss);
      }
    }
    EXPECT_LT(search.last().loss, loss(parameterisation.interpretation, parameterisation.held));
  }
  EXPECT_NE(all[0].searches[0].last().constants, all[0].searches[1].last().constants);

  // A look is what a search of so many evaluations ends with.
  ConvergencePlan half = plan;
  half.evaluations = 12;
  const auto shorter = converge({parameterisation}, half, store);
  for (std::size_t s = 0; s < 2; ++s) {
    EXPECT_EQ(all[0].searches[s].fits[1].constants, shorter[0].searches[s].last().constants);
    EXPECT_EQ(all[0].searches[s].fits[1].loss, shorter[0].searches[s].last().loss);
  }

  const auto written = std::filesystem::last_write_time(file);
  FitStore again(file);
  const auto resumed = converge({parameterisation}, plan, again);
  EXPECT_EQ(std::filesystem::last_write_time(file), written);
  for (std::size_t s = 0; s < 2; ++s) {
    EXPECT_EQ(resumed[0].searches[s].last().constants, all[0].searches[s].last().constants);
  }
}

}  // namespace
}  // namespace ricochet::studies::calibration
