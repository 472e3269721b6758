#include "src/studies/reproduction/page.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "solvers/solvers.h"
#include "tests/studies/reproduction/tiny_plan.h"

namespace ricochet::studies::reproduction {
namespace {

const Study& tiny_study() {
  static const Study study = make_study(tiny_plan(), all_solvers());
  return study;
}

const report::Section& section_of(const report::Page& page, const std::string& id) {
  for (const report::Section& section : page.sections) {
    if (section.id == id) return section;
  }
  throw std::out_of_range(id);
}

TEST(Page, DrawsChartsThatHoldTogether) {
  const report::Page page = page_of(tiny_study());
  std::set<std::string> names;
  for (const report::Section& section : page.sections) {
    for (const report::Figure& figure : section.figures) {
      EXPECT_NO_THROW(report::check(figure.chart)) << figure.chart.name;
      EXPECT_TRUE(names.insert(figure.chart.name).second) << figure.chart.name;
    }
    for (const report::Table& table : section.tables) {
      for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    }
  }
}

TEST(Page, KeepsEveryLineWithinItsBand) {
  int bands = 0;
  const report::Page page = page_of(tiny_study());
  for (const report::Figure& figure : section_of(page, "solvers").figures) {
    for (const report::Series& series : figure.chart.series) {
      for (const report::Sample& sample : series.samples) {
        if (!sample.spread) continue;
        ++bands;
        EXPECT_LE(sample.spread->lower, *sample.value) << figure.chart.name;
        EXPECT_GE(sample.spread->upper, *sample.value) << figure.chart.name;
      }
    }
  }
  EXPECT_GT(bands, 1000);
}

TEST(Page, SetsPaperAndComputationSideBySide) {
  const report::Page page = page_of(tiny_study());
  const report::Section& section = section_of(page, "thresholds");
  ASSERT_EQ(section.tables.size(), 3U);
  ASSERT_EQ(section.tables[0].rows.size(), 12U);
  const auto& c1 = section.tables[0].rows[0];
  EXPECT_EQ(c1[0].text, "C1");
  EXPECT_EQ(c1[4].text, "9");
  EXPECT_EQ(c1[5].text, fmt::format("{:.3f}", *tiny_study().cases[0].score.threshold));
  EXPECT_EQ(section.tables[0].rows[10][4].text, "–");
  EXPECT_EQ(section.tables[2].rows.size(), 10U);
}

TEST(Page, ShowsEveryCurveFigureMapAndContradiction) {
  const report::Page page = page_of(tiny_study());
  EXPECT_EQ(section_of(page, "counts").figures.size(), 12U);
  EXPECT_EQ(section_of(page, "paths").figures.size(), 20U);
  EXPECT_EQ(section_of(page, "crossing").figures.size(), 2U);
  EXPECT_EQ(section_of(page, "conclusions").figures.size(), 3U);
  EXPECT_EQ(section_of(page, "contradictions").tables[0].rows.size(), 11U);
}

TEST(Page, RanksEverySolverThatTakesPart) {
  const report::Section section = section_of(page_of(tiny_study()), "solvers");
  for (const report::Table& table : section.tables) EXPECT_GE(table.rows.size(), 15U);
}

TEST(Page, DoesNotDependOnTheTimesItShowsForItsTables) {
  const report::Page a = page_of(tiny_study());
  const report::Page b = page_of(make_study(tiny_plan(), all_solvers()));
  const auto& one = section_of(a, "thresholds").tables;
  const auto& two = section_of(b, "thresholds").tables;
  for (std::size_t t = 0; t < one.size(); ++t) {
    EXPECT_EQ(report::to_markdown(one[t]), report::to_markdown(two[t]));
  }
}

}  // namespace
}  // namespace ricochet::studies::reproduction
