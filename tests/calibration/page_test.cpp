#include "src/calibration/page.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <set>

#include "tests/calibration/tiny_study.h"

namespace ricochet::calibration {
namespace {

TEST(Page, HasTablesAndChartsThatHoldTogether) {
  const auto file = std::filesystem::path(testing::TempDir()) /
                    (std::string("page_") + std::to_string(getpid()) + ".toml");
  std::filesystem::remove(file);
  FitStore store(file);
  const Study study = make_study(tiny_plan(), store);
  const report::Page page = page_of(study);
  std::set<std::string> ids, charts;
  for (const report::Section& section : page.sections) {
    EXPECT_TRUE(ids.insert(section.id).second) << section.id;
    EXPECT_FALSE(section.paragraphs.empty()) << section.id;
    for (const report::Figure& figure : section.figures) {
      EXPECT_NO_THROW(report::check(figure.chart)) << figure.chart.name;
      EXPECT_TRUE(charts.insert(figure.chart.name).second) << figure.chart.name;
    }
    for (const report::Table& table : section.tables) {
      EXPECT_FALSE(table.rows.empty()) << section.id;
      for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    }
  }
  EXPECT_EQ(ids, (std::set<std::string>{"readings", "answers", "rankings", "frontier",
                                        "predictions", "constants", "origin"}));
  EXPECT_EQ(charts.size(), 2 + study.profiles.size());
}

}  // namespace
}  // namespace ricochet::calibration
