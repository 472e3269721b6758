#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "src/studies/paper/theory.h"
#include "tests/studies/reproduction/drawn_results.h"
#include "tests/studies/reproduction/tiny_plan.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;
using testing::HasSubstr;
using testing::Not;

double loss(double restitution) {
  return (1 - restitution) / (1 + restitution);
}

/// The paper's cases, with thresholds twice the formula's and a scene of hops higher than its gap.
std::vector<CaseStudy> made_cases() {
  Scene interpretation;
  interpretation.mass = 1.0;
  interpretation.pull = 1.0;
  interpretation.normal_force = 1.0;
  interpretation.wall_upper = 1e-3;
  interpretation.centrifugal_mass_radius = 0.1;
  std::vector<CaseStudy> cases;
  for (const auto& it : carrier_track::all_cases()) {
    CaseStudy& c = cases.emplace_back();
    c.the_case = it;
    c.scene = scene_of(it, interpretation);
    c.scan = {1.0, {1, 2}};
    c.score.threshold = 2 * std::sqrt(loss(it.restitution)) * std::exp(it.friction);
    c.score.examples = {{1.0, false, 1, true}, {2.0, true, 2, true}};
  }
  return cases;
}

/// The section that the report has of them.
report::Section theory_section(const std::vector<CaseStudy>& cases) {
  Results results;
  results.plan = tiny_plan();
  results.interpretation = carrier_track::default_interpretation();
  results.cases = cases;
  results.grid = {{0.1}, {0.1}, {0.0}, {1.0}};
  return section_of(page_of(kept_data(results)), "theory");
}

TEST(TheorySection, SetsEveryFormulaBesideBothThresholds) {
  const report::Section section = theory_section(made_cases());
  ASSERT_EQ(section.tables.size(), 1U);
  const auto& rows = section.tables[0].rows;
  ASSERT_EQ(rows.size(), 2 * (all_formulas().size() + 2));
  for (const auto& row : rows) {
    EXPECT_EQ(row.size(), section.tables[0].columns.size());
  }
  EXPECT_EQ(rows[0][0].text, "w = c");
  EXPECT_EQ(rows[0][1].text, "paper");
  EXPECT_EQ(rows[0][4].text, "0.0 %");
  EXPECT_EQ(rows[7][0].text, "w = c √R exp(k μ)");
  EXPECT_EQ(rows[7][1].text, "computed");
  EXPECT_EQ(rows[7][3].text, "c\u00a0=\u00a02, k\u00a0=\u00a01");
  EXPECT_EQ(rows[7][4].text, "100.0 %");
  EXPECT_EQ(rows[7][5].text, "0 %");
}

TEST(TheorySection, PredictsWithoutAConstantFromTheScene) {
  auto cases = made_cases();
  for (CaseStudy& c : cases) c.score.threshold = 1.1 * *sustained_bouncing_speed(c.scene);
  const auto rows = theory_section(cases).tables[0].rows;
  const auto& row = rows[rows.size() - 3];
  EXPECT_EQ(row[0].text, "sustained bouncing");
  EXPECT_EQ(row[1].text, "computed");
  EXPECT_EQ(row[5].text, "10 %");
  EXPECT_THAT(row[7].text, HasSubstr("-9 %"));
}

TEST(TheorySection, SaysForHowManyCasesTheSceneHasASpeed) {
  auto cases = made_cases();
  cases[2].scene.friction = 1.5;  // beyond the pull
  const auto rows = theory_section(cases).tables[0].rows;
  EXPECT_EQ(rows[rows.size() - 4][0].text, "sustained bouncing (9 of 10 cases)");
  EXPECT_EQ(rows[rows.size() - 2][0].text, "lift-off");
}

TEST(TheorySection, SetsThePredictedRatioBesideThePapers) {
  const report::Section section = theory_section(made_cases());
  const std::string& words = section.paragraphs.at(2);
  EXPECT_THAT(words, HasSubstr("3.94 times"));
  EXPECT_THAT(words, HasSubstr("In the paper it is 3.65 to 4.50 times"));
  EXPECT_THAT(words, HasSubstr("In the computed thresholds it is 3.94 times"));
  EXPECT_THAT(words, HasSubstr("comes out at 0.500 if left free."));
  const std::string& friction = section.paragraphs.at(3);
  EXPECT_THAT(friction, HasSubstr("1.44 to 1.49 and 1.55 to 1.58 (paper)"));
  EXPECT_THAT(friction, HasSubstr("1.35 and 1.35 (computed), and the limit"));  // exp(0.3)
}

TEST(TheorySection, IsSilentOnALimitThatTheModelDoesNotHave) {
  auto cases = made_cases();
  for (CaseStudy& c : cases) c.scene.pull_rotates = true;
  const std::string friction = theory_section(cases).paragraphs.at(3);
  EXPECT_THAT(friction, HasSubstr("(paper), and by 1.35 and 1.35 (computed)."));
  EXPECT_THAT(friction, Not(HasSubstr("–")));
}

TEST(TheorySection, NamesTheSpeedOfTheModelThatTheThresholdIs) {
  auto cases = made_cases();
  const auto words = [&](double low, double high) {
    for (CaseStudy& c : cases) {
      c.score.threshold =
          (c.the_case.restitution < 0.5 ? low : high) * lift_off_speed(c.scene).value();
    }
    return theory_section(cases).paragraphs.at(4);
  };
  EXPECT_THAT(words(3, 1.09), HasSubstr("they are 3.00 times the speed of lift-off at restitution "
                                        "0.1, and 1.09 times it at 0.9; at 0.9 the threshold is"));
  EXPECT_THAT(words(0.91, 3), HasSubstr("; at 0.1 the threshold is that speed"));
  EXPECT_THAT(words(1, 1), HasSubstr("1.00 times it at 0.9; within a tenth the threshold is"));
  EXPECT_THAT(words(1.11, 0.89), HasSubstr("0.89 times it at 0.9. For the other, they"));
  for (CaseStudy& c : cases) c.score.threshold.reset();
  EXPECT_THAT(theory_section(cases).paragraphs.at(4), HasSubstr("no lift-off"));
}

TEST(TheorySection, SaysWhetherTheCarrierHasTheRoom) {
  auto cases = made_cases();
  EXPECT_THAT(theory_section(cases).paragraphs.back(), HasSubstr("So it has no room"));
  for (CaseStudy& c : cases) c.scene.wall_upper = 1e3;
  EXPECT_THAT(theory_section(cases).paragraphs.back(), HasSubstr("can move as the formula"));
  for (CaseStudy& c : cases) c.scene.pull_rotates = true;
  EXPECT_THAT(theory_section(cases).paragraphs.back(),
              HasSubstr("not those of sustained bouncing"));
}

TEST(TheorySection, DrawsWhatThereIs) {
  auto cases = made_cases();
  const auto chart = theory_section(cases).figures.at(0).chart;
  report::check(chart);
  ASSERT_EQ(chart.series.size(), 6U);
  EXPECT_NEAR(chart.series[0].samples[0].position, std::sqrt(0.9 / 1.1), 1e-12);
  EXPECT_EQ(chart.series[0].samples[0].value, 9.0);
  EXPECT_EQ(chart.series[0].samples.size(), 6U);
  EXPECT_EQ(chart.series[1].samples.size(), 4U);
  const auto& line = chart.series[5].samples;  // 2 exp(the mean friction)
  EXPECT_NEAR(line[1].value.value(), 2 * std::exp(0.22), 1e-12);
  EXPECT_NEAR(*line[1].value / *line[0].value, line[1].position / line[0].position, 1e-12);
  for (CaseStudy& c : cases) c.score.threshold.reset();
  const auto section = theory_section(cases);
  report::check(section.figures.at(0).chart);
  EXPECT_EQ(section.figures[0].chart.series.size(), 3U);
  EXPECT_EQ(section.tables[0].rows[1][4].text, "–");
}

}  // namespace
}  // namespace ricochet::studies::reproduction
