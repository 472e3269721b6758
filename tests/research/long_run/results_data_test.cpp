#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "src/report/page_template.h"
#include "src/report/report.h"
#include "src/research/long_run/results.h"
#include "src/research/paper/fitted_interpretation.h"

namespace ricochet::studies::long_run {
namespace {

using namespace carrier_track;

/// Results that nobody computed: the page has to stand whatever they say.
Results some_results() {
  Results results;
  results.plan = quick_plan();
  const FittedInterpretation& usual = default_interpretation();
  const calibration::Fit fit{usual.interpretation, usual.free, usual.constants, 22, ""};
  const calibration::Appraisal appraisal = calibration::appraise(fit, 1.0);
  const std::vector<double> left_out(10, 0.065);
  results.usual = {fit, appraisal, left_out};
  for (const CountInterpretation& what : count_interpretations()) {
    results.counts.push_back({what, fit, 50, appraisal, left_out});
    results.counts.back().appraisal.purity = what.goal == Goal::purity ? 0.93 : 0.5;
  }
  results.counts[1].loss = 40;
  for (const BorderInterpretation& what : border_interpretations()) {
    BorderFit border{what, usual.constants, {}, {}, {}, {}, {}};
    border.law_errors = border.errors = std::vector<double>(10, -0.1);
    border.left_out = std::vector<double>(10, 0.12);
    border.directions = {{std::vector<double>(what.free.size(), 0.5), 0.06},
                         {std::vector<double>(what.free.size(), 0.5), 5}};
    for (const Unknown open : what.free) {
      border.intervals.push_back({open, 2, 1, 3, true, false});
    }
    results.borders.push_back(border);
  }
  results.borders[2].left_out[0] = 0.01;
  const FormulaWorth worth{8, 1.4, 0.1, -0.3, 0.2, -0.25};
  results.law = {{{0.1, 0.1, 8.0, 8.0}, {0.9, 0.1, 2.0, std::nullopt}, {0.1, 0.4, {}, 12.0}},
                 1e-11,
                 0.01,
                 1e-10,
                 worth,
                 worth,
                 worth};
  return results;
}

report::Page page_of(const Results& results) {
  report::Json data = data_of(results);
  data["made"] = {{"version", "1.2.3"}, {"seconds", 4.5}, {"threads", 2}};
  return report::drawn(report::page_template("long-run"), data).page;
}

TEST(LongRunData, FillTablesAndChartsThatHoldTogether) {
  const report::Page page = page_of(some_results());
  std::set<std::string> charts;
  for (const report::Section& section : page.sections) {
    EXPECT_FALSE(section.paragraphs.empty()) << section.id;
    for (const report::Figure& figure : section.figures) {
      EXPECT_NO_THROW(report::check(figure.chart)) << figure.chart.name;
      charts.insert(figure.chart.name);
    }
    for (const report::Table& table : section.tables) {
      EXPECT_FALSE(table.rows.empty()) << section.id;
      for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    }
  }
  EXPECT_EQ(charts, (std::set<std::string>{"threshold-over-restitution-0-1",
                                           "threshold-over-restitution-0-4"}));
}

TEST(LongRunData, SetBordersAndCountsBesideTheDefault) {
  const auto rows = page_of(some_results()).sections.at(0).tables.at(0).rows;
  ASSERT_EQ(rows.size(), 1 + count_interpretations().size() + border_interpretations().size());
  EXPECT_EQ(rows[0][1].text, "5");
  EXPECT_EQ(rows[0][4].text, "6.5 [6.5, 6.5]");
  EXPECT_EQ(rows[0][9].text, "22.0");
  EXPECT_EQ(rows[2][9].text, "40.0");
  EXPECT_EQ(rows[2][6].text, "50");
  EXPECT_EQ(rows.back()[2].text, "10.0 [10.0, 10.0]");
  EXPECT_EQ(rows.back()[5].text, "–");
  const auto thresholds = page_of(some_results()).sections.at(0).tables.at(1).rows;
  EXPECT_EQ(thresholds.back()[1].text, "8.144");  // 9 exp(-0.1)
}

TEST(LongRunData, SayWhetherThePurityIsReachedAndByWhich) {
  Results results = some_results();
  EXPECT_NE(page_of(results).intro.at(0).find("A purity of 90 % is reached by long-run-pure"),
            std::string::npos)
      << page_of(results).intro.at(0);
  for (CountFit& c : results.counts) c.appraisal.purity = 0.5;
  EXPECT_NE(page_of(results).intro.at(0).find("No count of the long run reaches"),
            std::string::npos);
}

TEST(LongRunData, PutTheBorderThatPredictsBestInTheHeadline) {
  const report::Json data = data_of(some_results());
  EXPECT_EQ(data["best_border"]["parameters"], 5);
  EXPECT_EQ(data["best_border"]["determined"], 1);
  EXPECT_EQ(data["nearest"]["loss"], 40);
}

TEST(RootMeanSquareOfErrors, HasAnIntervalOverTheCases) {
  const RootMeanSquare alike = root_mean_square({0.1, -0.1, 0.1, -0.1});
  EXPECT_NEAR(alike.value, 0.1, 1e-12);
  EXPECT_NEAR(alike.interval.lower, 0.1, 1e-12);
  EXPECT_NEAR(alike.interval.upper, 0.1, 1e-12);
  const RootMeanSquare one = root_mean_square({0, 0, 0, 0.2});
  EXPECT_NEAR(one.value, 0.1, 1e-12);
  EXPECT_EQ(one.interval.lower, 0);
  EXPECT_NEAR(one.interval.upper, 0.2 * std::sqrt(0.75), 0.03);
}

}  // namespace
}  // namespace ricochet::studies::long_run
