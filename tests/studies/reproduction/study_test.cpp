#include "src/studies/reproduction/study.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "ricochet/error.h"
#include "src/studies/suite/suite.h"
#include "tests/core/temporary_folder.h"
#include "tests/studies/reproduction/tiny_plan.h"

namespace ricochet::studies::reproduction {
namespace {

using carrier_track::Example;

class ReproductionStudy : public TemporaryFolder {
 protected:
  Findings findings(const std::string& file, const std::string& version = "1") const {
    return findings_of(tiny_plan(), whole_catalogue(),
                       {folder_ / file, {{{"version", version}}, {}}});
  }
};

TEST_F(ReproductionStudy, HasEveryCaseEveryFigureAndEveryRunOfTheComparison) {
  const Findings found = findings("comparison.sqlite");
  ASSERT_EQ(found.cases.size(), 12U);
  int figures = 0;
  for (const CaseStudy& c : found.cases) {
    EXPECT_EQ(c.scan.counts.size(), 180U);
    EXPECT_EQ(c.staircase.levels.size(), c.staircase.steps.size() + 1);
    EXPECT_EQ(c.paths.has_value(), c.the_case.claim.figure.has_value());
    if (!c.paths) continue;
    ++figures;
    ASSERT_EQ(c.score.examples.size(), 2U);
    EXPECT_EQ(c.paths->quiet.count, c.score.examples[0].count);
    EXPECT_EQ(c.paths->loud.count, c.score.examples[1].count);
  }
  EXPECT_EQ(figures, 10);
  const auto& [campaign, store] = *found.comparison;
  EXPECT_EQ(campaign.problems().size(), 3U);
  EXPECT_GT(campaign.cells().size(), 3U * 2U * 20U);
  EXPECT_EQ(store.size(), campaign.runs());
  store.each([](const StoredRun& run) { EXPECT_EQ(run.record.failure, "") << name_of(run.key); });
}

TEST_F(ReproductionStudy, KeepsTheRunsOfItsComparisonUntilTheProgramIsAnother) {
  const auto seconds = [&](const std::string& version) {
    double sum = 0;
    findings("comparison.sqlite", version).comparison->store.each([&](const StoredRun& run) {
      sum += run.record.ledger.seconds;
    });
    return sum;
  };
  const double first = seconds("1");
  EXPECT_EQ(seconds("1"), first) << "no run is made again";
  Store::open(folder_ / "comparison.sqlite", Store::For::reading);
}

TEST_F(ReproductionStudy, MakesAStoreOfAnotherPlanAnew) {
  {
    const auto other =
        plan_from("[[part]]\nproblems = \"count-C1\"\nsolvers = \"scan\"\nbudgets = 5", "other");
    stored_campaign(other, whole_catalogue(), folder_ / "comparison.sqlite", {});
  }
  EXPECT_EQ(findings("comparison.sqlite").comparison->campaign.problems().size(), 3U);
  std::ofstream(folder_ / "mine") << "my diary";
  EXPECT_THROW(findings("mine"), InputError);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "mine")) << "no store";
}

TEST_F(ReproductionStudy, IsTheSameOnAnyNumberOfThreads) {
  Findings one;
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    one = findings("one.sqlite");
  }
  const Findings two = findings("two.sqlite");
  for (std::size_t i = 0; i < one.cases.size(); ++i) {
    EXPECT_EQ(one.cases[i].scan.counts, two.cases[i].scan.counts);
    EXPECT_EQ(one.cases[i].score.threshold, two.cases[i].score.threshold);
  }
  EXPECT_EQ(one.grid.means, two.grid.means);
  EXPECT_EQ(json_of(results_of(one)), json_of(results_of(two)));
}

TEST(Study, ComparesByPlansOfOnePartWhichIsUndisturbed) {
  for (const StudyPlan& plan : {full_plan(), quick_plan()}) {
    EXPECT_TRUE(plan.comparison.solvers.empty());
    ASSERT_EQ(plan.comparison.parts.size(), 1U);
    const PlanPart& part = plan.comparison.parts.front();
    const PlanPart usual;
    EXPECT_EQ(part.perturbations, usual.perturbations);
    EXPECT_EQ(part.gradient_prices, usual.gradient_prices);
    EXPECT_EQ(part.seeds, usual.seeds);
    EXPECT_EQ(part.machines, usual.machines);
    EXPECT_EQ(part.drawn_machines, 0);
    EXPECT_FALSE(part.relocated_optimum);
  }
}

TEST(Study, AgreesWithThePaperByTheLogarithmOfTheRatio) {
  std::vector<CaseStudy> cases(3);
  cases[0].the_case.claim.threshold = 2.0;
  cases[0].score.threshold = 4.0;
  cases[1].the_case.claim.threshold = 9.0;
  cases[1].score.threshold = 9.0;
  cases[2].score.threshold = 5.0;  // the paper has none
  cases[0].score.examples = {Example{1.0, false, 3, true}, Example{8.0, true, 3, false}};
  const Agreement agreement = agreement_of(cases);
  EXPECT_EQ(agreement.thresholds, 2);
  EXPECT_DOUBLE_EQ(agreement.relative_error, std::log(2.0) / std::sqrt(2.0));
  // Two of four samples have one error twice.
  ASSERT_TRUE(agreement.interval);
  EXPECT_EQ(agreement.interval->lower, 0);
  EXPECT_DOUBLE_EQ(agreement.interval->upper, std::log(2.0));
  EXPECT_FALSE(agreement_of({}).interval);
  EXPECT_EQ(agreement.examples, 2);
  EXPECT_EQ(agreement.right, 1);
}

}  // namespace
}  // namespace ricochet::studies::reproduction
