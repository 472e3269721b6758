#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "src/studies/calibration/results.h"
#include "tests/studies/calibration/tiny_plan.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

RankedFit natural_fit(const Interpretation& interpretation) {
  return {{interpretation, unknowns_of(interpretation), natural_constants(), 50, {}}, {}};
}

/// Of a tiny plan, with these interpretations ranked.
Results results_of(const std::vector<Interpretation>& interpretations) {
  Results results;
  results.plan = tiny_plan();
  for (const Interpretation& r : interpretations) results.interpretations.push_back(natural_fit(r));
  results.frontier = {natural_fit(Interpretation{})};
  return results;
}

/// With a store that holds nothing yet.
std::vector<Convergence> searched(const Results& results) {
  const auto file = std::filesystem::path(testing::TempDir()) /
                    ("long_searches_" + std::to_string(getpid()) + ".toml");
  std::filesystem::remove(file);
  FitStore store(file);
  return long_searches(results, store);
}

TEST(LongSearches, TakeEveryInterpretationOnceAsFreeAsTheDefaultOne) {
  Interpretation weight, seconds, crossing;
  weight.normal_force = NormalForce::weight;
  seconds.window = WindowUnit::seconds;
  crossing.transition = Transition::crossing;
  Results results = results_of({crossing, Interpretation{}, weight, seconds});
  results.plan.convergence->interpretations = 100;
  const auto all = searched(results);
  ASSERT_GT(all.size(), 5U);
  EXPECT_EQ(all[2].parameterisation.interpretation, Interpretation{})
      << "the best whose cases share a scene";
  std::vector<Interpretation> interpretations = {all[1].parameterisation.interpretation};
  for (std::size_t i = 3; i < all.size(); ++i)
    interpretations.push_back(all[i].parameterisation.interpretation);
  const auto has = [&](const Interpretation& r) { return std::ranges::count(interpretations, r); };
  EXPECT_EQ(has(default_interpretation().interpretation), 1);
  EXPECT_EQ(has(crossing), 0);
  // At the normal force that the default interpretation holds, the weight is no other
  // interpretation.
  EXPECT_EQ(has(weight) + has(Interpretation{}), 1);
  const auto same = std::ranges::find_if(
      all, [&](const Convergence& c) { return c.parameterisation.interpretation == seconds; });
  ASSERT_NE(same, all.end());
  EXPECT_TRUE(contains(same->parameterisation.free, Unknown::seconds));
  EXPECT_EQ(same->parameterisation.free.size(), default_interpretation().free.size());
}

/// Those that rank interpretations, from these seeds.
std::vector<Convergence> of_interpretations(const std::vector<int>& seeds) {
  Results results = results_of({Interpretation{}});
  results.plan.convergence->seeds = seeds;
  const std::vector<Convergence> all = searched(results);
  return {all.begin() + 3, all.end()};
}

TEST(LongSearches, OfInterpretationsAreBriefWhereTheyAgree) {
  const ConvergencePlan plan = *tiny_plan().convergence;
  const auto alike = of_interpretations({1, 1});
  ASSERT_FALSE(alike.empty());
  for (const Convergence& c : alike) EXPECT_EQ(c.evaluations, plan.interpretation_evaluations);
  const auto unlike = of_interpretations({1, 2});
  ASSERT_FALSE(unlike.empty());
  for (const Convergence& c : unlike) EXPECT_EQ(c.evaluations, plan.evaluations);
  for (std::size_t i = 0; i < unlike.size(); ++i) {
    EXPECT_EQ(unlike[i].parameterisation.interpretation, alike[i].parameterisation.interpretation);
  }
}

}  // namespace
}  // namespace ricochet::studies::calibration
