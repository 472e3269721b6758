#include "src/studies/reproduction/study.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>

#include "src/studies/contest/catalogue.h"
#include "tests/studies/reproduction/tiny_plan.h"

namespace ricochet::studies::reproduction {
namespace {

using carrier_track::Example;

TEST(Study, HoldsEveryCaseEveryFigureAndEveryContest) {
  const Results results = results_of(tiny_plan(), whole_catalogue());
  ASSERT_EQ(results.cases.size(), 12U);
  int figures = 0;
  for (const CaseStudy& c : results.cases) {
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
  EXPECT_EQ(results.contest.questions.size(), 3U);
  EXPECT_GT(results.standings.size(), 3U * 2U * 20U);
  for (const contest::Standing& standing : results.standings) {
    ASSERT_EQ(standing.outcomes.size(), 2U);
    for (const contest::Outcome& o : standing.outcomes) EXPECT_EQ(o.failure, "") << standing.solver;
  }
}

TEST(Study, IsTheSameOnAnyNumberOfThreads) {
  Results one;
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    one = results_of(tiny_plan(), whole_catalogue());
  }
  const Results two = results_of(tiny_plan(), whole_catalogue());
  for (std::size_t i = 0; i < one.cases.size(); ++i) {
    EXPECT_EQ(one.cases[i].scan.counts, two.cases[i].scan.counts);
    EXPECT_EQ(one.cases[i].score.threshold, two.cases[i].score.threshold);
  }
  EXPECT_EQ(one.grid.means, two.grid.means);
  EXPECT_EQ(data_of(one)["comparison"]["groups"][0]["budgets"],
            data_of(two)["comparison"]["groups"][0]["budgets"]);
}

TEST(Study, ComparesByPlansOfOnePartWhichIsUndisturbed) {
  for (const StudyPlan& plan : {full_plan(), quick_plan()}) {
    EXPECT_TRUE(plan.comparison.solvers.empty());
    ASSERT_EQ(plan.comparison.parts.size(), 1U);
    const PlanPart& part = plan.comparison.parts.front();
    const PlanPart usual;
    EXPECT_EQ(part.features, usual.features);
    EXPECT_EQ(part.gradient_prices, usual.gradient_prices);
    EXPECT_EQ(part.seeds, usual.seeds);
    EXPECT_EQ(part.machines, usual.machines);
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
  EXPECT_EQ(agreement.examples, 2);
  EXPECT_EQ(agreement.right, 1);
}

}  // namespace
}  // namespace ricochet::studies::reproduction
