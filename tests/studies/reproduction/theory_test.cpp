#include "src/studies/paper/theory.h"

#include <gtest/gtest.h>

#include <cmath>

#include "src/studies/reproduction/sections.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;

double loss(double restitution) {
  return (1 - restitution) / (1 + restitution);
}

/// The paper's cases, with thresholds twice the formula's.
std::vector<CaseStudy> made_cases() {
  std::vector<CaseStudy> cases;
  for (const auto& it : carrier_track::all_cases()) {
    CaseStudy& c = cases.emplace_back();
    c.the_case = it;
    c.score.threshold = 2 * std::sqrt(loss(it.restitution)) * std::exp(it.friction);
  }
  return cases;
}

report::Results theory_of(const std::vector<CaseStudy>& cases) {
  report::Results results;
  add_theory(cases, results);
  return results;
}

TEST(Theory, FitsEveryFormulaToBothThresholds) {
  const report::Results results = theory_of(made_cases());
  const Table& formulas = *results.table("formulas");
  ASSERT_EQ(formulas.rows.size(), all_formulas().size());
  EXPECT_EQ(formulas[0].text("formula"), "w = c");
  EXPECT_NEAR(formulas[0].number("explained"), 0, 1e-12);
  const auto row =
      formulas.find([](const Row& r) { return r.text("formula") == "w = c √R exp(k μ)"; });
  ASSERT_TRUE(row);
  EXPECT_NEAR(row->number("computed_error"), 0, 1e-12) << "that is how they were made";
  EXPECT_NEAR(row->number("computed_left_out"), 0, 1e-12);
  EXPECT_GT(row->number("left_out"), row->number("error"));
  EXPECT_EQ(*results.value("formula.error"), (*row)["error"]);
  // By hand: 7.56 and 1.45 from the ten thresholds.
  EXPECT_EQ(row->text("constants"), "c = 7.56, k = 1.45");
}

TEST(Theory, SetsThePredictedFactorsBesideThePapers) {
  const report::Results results = theory_of(made_cases());
  const Table& factors = *results.table("factors");
  EXPECT_NEAR(factors[0].number("formula"), std::sqrt(loss(0.1) / loss(0.9)), 1e-12);
  EXPECT_EQ(factors[0].text("paper"), "3.65 to 4.50");  // 7.3 / 2, 9 / 2
  EXPECT_EQ(factors[0].text("computed"), "3.94");
  EXPECT_EQ(factors[1].text("paper"), "1.44 to 1.49");
  EXPECT_EQ(factors[2].text("paper"), "1.55 to 1.58");
  EXPECT_EQ(factors[2].text("computed"), "1.35");  // exp(0.3)
}

TEST(Theory, DrawsWhatThereIs) {
  auto cases = made_cases();
  const report::Results results = theory_of(cases);
  const report::Chart& chart = *results.chart("theory");
  report::check(chart);
  ASSERT_EQ(chart.series.size(), 6U);
  EXPECT_NEAR(chart.series[0].samples.back().position, std::sqrt(0.9 / 1.1), 1e-12);
  EXPECT_EQ(chart.series[0].samples.size(), 6U);
  EXPECT_EQ(chart.series[1].samples.size(), 4U);
  const auto& line = chart.series[5].samples;  // 2 exp(the mean friction)
  EXPECT_NEAR(line[1].value.value(), 2 * std::exp(0.22), 1e-12);
  EXPECT_NEAR(*line[1].value / *line[0].value, line[1].position / line[0].position, 1e-12);
  for (CaseStudy& c : cases) c.score.threshold.reset();
  const report::Results none = theory_of(cases);
  report::check(*none.chart("theory"));
  EXPECT_EQ(none.chart("theory")->series.size(), 3U);
  EXPECT_FALSE((*none.table("formulas"))[1].number_if("computed_error"));
}

}  // namespace
}  // namespace ricochet::studies::reproduction
