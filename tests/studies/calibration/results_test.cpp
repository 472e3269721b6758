#include "src/studies/calibration/results.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "tests/studies/calibration/tiny_plan.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

Results results_of(const Plan& plan) {
  Searches searches(fresh_file(), some_provenance());
  return calibrate(plan, searches);
}

TEST(Results, RankInterpretationsHoldConstantsAndPredict) {
  const Results results = results_of(tiny_plan());
  ASSERT_GE(results.interpretations.size(), 2U + 11 + 5);
  EXPECT_TRUE(std::ranges::is_sorted(results.interpretations, {},
                                     [](const RankedFit& r) { return r.fit.loss; }));
  for (std::size_t i = 1; i < results.frontier.size(); ++i) {
    EXPECT_EQ(results.frontier[i].fit.free.size(), results.frontier[i - 1].fit.free.size() - 1);
  }
  for (const RankedFit& r : results.frontier) {
    EXPECT_GE(r.appraisal.criterion, results.frontier[results.chosen].appraisal.criterion);
  }
  // The choice, the default interpretation, the best one, and those as free as the default one.
  ASSERT_GE(results.convergence.size(), 3U + 2);
  ASSERT_LE(results.convergence.size(), 3U + 3);
  ASSERT_EQ(results.converged.size(), results.convergence.size());
  EXPECT_EQ(results.convergence[1].fits[0].free, default_interpretation().free);
  for (std::size_t i = 0; i < results.convergence.size(); ++i) {
    const Convergence& one = results.convergence[i];
    EXPECT_EQ(one.evaluations, i >= 3 && one.agrees() && one.evaluations == 3 ? 3 : 4);
    ASSERT_EQ(one.fits.size(), 2U);
    ASSERT_FALSE(results.converged[i].empty());
    EXPECT_EQ(results.converged[i].size(), one.as_good().size());
    for (const RankedFit& r : results.converged[i]) {
      EXPECT_LE(r.fit.loss, 1.01 * best_of(one.fits).loss);
      EXPECT_GE(r.appraisal.criterion, results.converged[i].front().appraisal.criterion);
    }
    EXPECT_GE(results.converged[i].front().appraisal.criterion,
              results.choice().appraisal.criterion);
  }
  EXPECT_EQ(results.predictions.size(), 50U);
  EXPECT_EQ(results.profiles.size(), results.choice().fit.free.size());
}

TEST(Results, SearchEveryInterpretationOnceAsFreeAsTheDefaultOne) {
  Plan plan = tiny_plan();
  Interpretation weight, seconds, crossing;
  weight.normal_force = NormalForce::weight;
  seconds.window = WindowUnit::seconds;
  crossing.transition = Transition::crossing;
  plan.interpretations = {crossing, Interpretation{}, weight, seconds};
  plan.long_searches->interpretations = 100;
  const Results results = results_of(plan);
  const FittedInterpretation& usual = default_interpretation();
  std::vector<Interpretation> of_others;
  for (std::size_t i = 3; i < results.convergence.size(); ++i)
    of_others.push_back(results.convergence[i].fits[0].interpretation);
  ASSERT_GT(of_others.size(), 3U);
  const auto times = [&](const Interpretation& r) { return std::ranges::count(of_others, r); };
  EXPECT_EQ(results.convergence[1].fits[0].interpretation, usual.interpretation);
  EXPECT_EQ(times(usual.interpretation), 0);
  EXPECT_EQ(times(crossing), 0) << "its cases share no scene";
  // At the normal force that the default interpretation holds, the weight is no other
  // interpretation.
  EXPECT_EQ(times(weight) + times(Interpretation{}), 1);
  for (const Convergence& one : results.convergence) {
    const Fit& fit = one.fits[0];
    if (fit.interpretation != seconds || fit.free.size() != usual.free.size()) continue;
    EXPECT_TRUE(contains(fit.free, Unknown::seconds));
  }
  EXPECT_EQ(times(seconds), 1);
}

/// The evaluations of the searches that rank interpretations, from these seeds.
std::set<std::int64_t> evaluations_from(const std::vector<int>& seeds) {
  Plan plan = tiny_plan();
  plan.interpretations = {Interpretation{}};
  plan.long_searches->seeds = seeds;
  const Results results = results_of(plan);
  std::set<std::int64_t> evaluations;
  for (std::size_t i = 3; i < results.convergence.size(); ++i)
    evaluations.insert(results.convergence[i].evaluations);
  return evaluations;
}

TEST(Results, OfBriefSearchesStandWhereTheyAgree) {
  EXPECT_EQ(evaluations_from({1, 1}), std::set<std::int64_t>{3});
  EXPECT_EQ(evaluations_from({1, 2}), std::set<std::int64_t>{4});
}

TEST(Convergence, IsThatTheWorstSearchIsNearTheBest) {
  const auto of = [](const std::vector<double>& losses) {
    Convergence one;
    for (const double loss : losses) one.fits.push_back({{}, loss});
    return one;
  };
  EXPECT_TRUE(of({20, 20.1}).agrees());
  EXPECT_FALSE(of({20, 20.3}).agrees());
  EXPECT_EQ(of({20.3, 20, 20.1}).as_good().size(), 2U);
}

}  // namespace
}  // namespace ricochet::studies::calibration
