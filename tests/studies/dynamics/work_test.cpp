#include "src/studies/dynamics/work.h"

#include <gtest/gtest.h>

#include "problems/carrier_track/motion/compliant_model.h"
#include "ricochet/machine.h"

namespace ricochet::studies::dynamics {
namespace {

const WorkPlan coarse{1, 1e-10, 1e3};

const std::vector<SceneWork>& works() {
  static const std::vector<SceneWork> all = [] {
    std::vector<SceneWork> result;
    for (const BenchmarkScene& benchmark : benchmark_scenes(5)) {
      result.push_back(work_in(benchmark, coarse, carrier_track::all_integrators()));
    }
    return result;
  }();
  return all;
}

TEST(Work, OfTheReferenceAgainstItselfIsWithoutError) {
  for (const SceneWork& work : works()) {
    const MethodWork& reference = work.methods.front();
    EXPECT_EQ(reference.method, "event-driven");
    ASSERT_EQ(reference.trials.size(), 1U);
    if (work.benchmark.chaotic) {
      EXPECT_LT(*reference.trials[0].error, work.rate_spread);
    } else {
      EXPECT_EQ(reference.trials[0].error, 0.0) << work.benchmark.id;
    }
    EXPECT_EQ(reference.trials[0].accuracy.missed, 0);
    EXPECT_GT(reference.trials[0].seconds, 0);
  }
}

TEST(Work, BuysAccuracyInTheMildScene) {
  const SceneWork& mild = works().front();
  for (std::size_t m = 1; m < mild.methods.size(); ++m) {
    const MethodWork& method = mild.methods[m];
    const Trial& tightest = method.trials.back();
    ASSERT_TRUE(tightest.error.has_value()) << method.method;
    for (const Trial& trial : method.trials) {
      if (!trial.error) continue;
      EXPECT_LT(*tightest.error, 0.1 * *trial.error) << method.method;  // than at the loosest
      break;
    }
    EXPECT_GT(tightest.force_evaluations, method.trials.front().force_evaluations);
  }
}

TEST(Work, ComesOutTheSameAgainButForTheTimes) {
  const SceneWork& one = works().front();
  const SceneWork two = work_in(one.benchmark, coarse, carrier_track::all_integrators());
  for (std::size_t m = 0; m < one.methods.size(); ++m) {
    ASSERT_EQ(one.methods[m].trials.size(), two.methods[m].trials.size());
    for (std::size_t t = 0; t < one.methods[m].trials.size(); ++t) {
      const Trial& a = one.methods[m].trials[t];
      const Trial& b = two.methods[m].trials[t];
      EXPECT_EQ(a.error, b.error) << one.methods[m].method;
      EXPECT_EQ(a.force_evaluations, b.force_evaluations) << one.methods[m].method;
    }
  }
}

TEST(Work, HasImpactsInEveryScene) {
  for (const SceneWork& work : works()) {
    EXPECT_GE(work.impacts, 2) << work.benchmark.id;
    EXPECT_EQ(work.rate_spread > 0, work.benchmark.chaotic) << work.benchmark.id;
  }
}

/// Collects the impacts of a simulation.
struct Collector : carrier_track::Observer {
  carrier_track::Outcome outcome;

  void impact(double time, carrier_track::Wall wall, double speed) {
    outcome.impacts.push_back({time, wall, speed});
  }
};

TEST(Work, InStiffScenesHasAReferenceThatItsOwnToleranceAndAnotherMethodConfirm) {
  for (const BenchmarkScene& benchmark : stiff_benchmark_scenes()) {
    const auto integrators = through_walls();
    const carrier_track::Outcome reference = integrators.front().run(benchmark.scene, 0);
    ASSERT_GE(reference.impacts.size(), 8U);
    Collector looser;
    carrier_track::CompliantModel(benchmark.scene, 1e-11).run(looser);
    const carrier_track::Outcome rosenbrock = integrators[2].run(benchmark.scene, 1e-12);
    for (const carrier_track::Outcome& other : std::vector{looser.outcome, rosenbrock}) {
      const auto accuracy = compare(benchmark.scene, other, reference);
      EXPECT_EQ(accuracy.missed + accuracy.spurious, 0) << benchmark.id;
      EXPECT_LT(*accuracy.impact_time_error, 1e-11) << benchmark.id;
    }
  }
}

TEST(Work, OfFixedStepsIsLostOnVeryStiffWallsUntilTheStepIsShort) {
  const BenchmarkScene benchmark = stiff_benchmark_scenes().back();
  const SceneWork work = work_in(benchmark, {1, 1e-6, 1e3}, through_walls());
  for (const MethodWork& method : work.methods) {
    for (const Trial& trial : method.trials) {
      EXPECT_EQ(trial.finished, method.control != "step [s]") << method.method;
    }
  }
}

TEST(Work, GivesTheLoosestControlFromWhichOnAllAreGoodEnough) {
  const auto trial = [](double control, std::optional<double> error) {
    return Trial{control, 1, 1, true, {}, error};
  };
  const MethodWork method{"a",
                          "step [s]",
                          {trial(1, 1e-7), trial(0.1, std::nullopt), trial(0.01, 1e-7),
                           trial(1e-3, 1e-8), trial(1e-4, 1e-8)}};
  EXPECT_EQ(loosest_within(method, 1e-6)->control, 0.01);
  EXPECT_EQ(loosest_within(method, 1e-8)->control, 1e-3);
  EXPECT_FALSE(loosest_within(method, 1e-9).has_value());
}

}  // namespace
}  // namespace ricochet::studies::dynamics
