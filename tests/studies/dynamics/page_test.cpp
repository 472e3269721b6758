#include "src/studies/dynamics/page.h"

#include <gtest/gtest.h>

#include <set>

namespace ricochet::studies::dynamics {
namespace {

const Study& tiny_study() {
  static const Study study = make_study({48,
                                         5,
                                         {1, 1e-6, 1e2},
                                         {{6}, {1e12}},
                                         {{1e8, 1e12}, {1e-4, 1e-5}, {1e-4}, 4},
                                         {{6}, 4, {5}, 1},
                                         {2, 100, 2, 1},
                                         {9, {0, 1}, 1e10, 1}});
  return study;
}

TEST(Page, DrawsChartsThatHoldTogether) {
  const report::Page page = page_of(tiny_study());
  std::set<std::string> names, ids;
  for (const report::Section& section : page.sections) {
    EXPECT_TRUE(ids.insert(section.id).second) << section.id;
    for (const report::Figure& figure : section.figures) {
      EXPECT_NO_THROW(report::check(figure.chart)) << figure.chart.name;
      EXPECT_TRUE(names.insert(figure.chart.name).second) << figure.chart.name;
    }
    for (const report::Table& table : section.tables) {
      for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    }
  }
  EXPECT_EQ(names.size(), 1U + 5 + 9 + 2 + 1 + 3 + 2 + 1);
}

TEST(Page, BeginsEverySectionWithWhatItFound) {
  const report::Page page = page_of(tiny_study());
  for (const report::Section& section : page.sections) {
    if (section.id == "origin") continue;
    EXPECT_EQ(section.paragraphs.at(0).rfind("Found: ", 0), 0U) << section.id;
  }
}

TEST(Page, KeepsFailuresOnTheChart) {
  const report::Page page = page_of(tiny_study());
  for (const report::Section& section : page.sections) {
    for (const report::Figure& figure : section.figures) {
      if (figure.chart.name.rfind("work-", 0) != 0) continue;
      const double rail = figure.chart.lines.at(0).position;
      EXPECT_LT(rail, figure.chart.y.range->upper);
      std::size_t points = 0;
      for (const report::Series& series : figure.chart.series) {
        points += series.samples.size();
        for (const report::Sample& sample : series.samples) EXPECT_LE(*sample.value, rail);
      }
      const bool hard = figure.chart.name.find("stiff") == std::string::npos;
      EXPECT_EQ(points, 4U * 4 + (hard ? 3 : 2) * 2) << figure.chart.name;
    }
  }
}

TEST(Page, CountsEveryCaseByHardAndCompliantWalls) {
  const FidelityStudy& fidelity = tiny_study().fidelity;
  ASSERT_EQ(fidelity.cells.size(), 12U);
  for (const auto& row : fidelity.cells) {
    ASSERT_EQ(row.size(), 1U);
    EXPECT_LE(row[0].equal, row[0].compared);
    EXPECT_LE(row[0].compared, 1);
  }
}

}  // namespace
}  // namespace ricochet::studies::dynamics
