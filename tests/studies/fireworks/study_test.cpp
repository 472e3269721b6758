#include "src/studies/fireworks/study.h"

#include <gtest/gtest.h>

#include "src/report/page_template.h"
#include "src/report/report.h"

namespace ricochet::studies {
namespace {

using namespace fireworks;
using report::Json;

/// All parts of the study, of next to no runs.
const Json& results() {
  static const Json made = {{"made", {{"version", "1.2.3"}, {"seconds", 4.5}, {"quick", true}}},
                            {"table_3", table_3_data(3)},
                            {"shift", shift_data(3)},
                            {"competition", competition_data(2, 2000)},
                            {"plateau", plateau_data(10)}};
  return made;
}

TEST(FireworksStudy, FillsItsPage) {
  const report::DrawnPage drawn = report::drawn(report::page_template("fireworks"), results());
  EXPECT_GE(drawn.page.sections.size(), 5U);
  for (const report::Section& section : drawn.page.sections) {
    EXPECT_FALSE(section.paragraphs.empty()) << section.id;
    for (const report::Table& table : section.tables) EXPECT_FALSE(table.rows.empty());
    for (const report::Figure& figure : section.figures) {
      EXPECT_NO_THROW(report::check(figure.chart));
    }
  }
}

TEST(FireworksStudy, ReproducesTheSevenZerosOf2010) {
  EXPECT_EQ(results()["table_3"]["zeros"], 7);
  for (const Json& interpretation : results()["table_3"]["interpretations"]) {
    EXPECT_EQ(interpretation["zeros"], 7) << interpretation["name"];
  }
  for (const Json& row : results()["table_3"]["rows"]) {
    for (const Json& cell : row["successors"]) EXPECT_GT(cell["mean"], 1e-3) << row["function"];
  }
}

TEST(FireworksStudy, SeesWhoFavoursTheOrigin) {
  EXPECT_EQ(results()["shift"]["biased"],
            (Json{"fireworks", "fireworks-as-printed", "fireworks-authors"}));
}

TEST(FireworksStudy, ComparesAllThatHasFigures) {
  const Json& rows = results()["competition"]["rows"];
  if (rows.empty()) GTEST_SKIP() << "built without pagmo";
  EXPECT_EQ(rows.size(), 6U);
  EXPECT_EQ(results()["competition"]["compared"], 24);
  EXPECT_EQ(results()["competition"]["solvers"],
            (Json{"fireworks-authors", "fireworks-corrected", "efwa", "dynfwa", "bbfwa", "lotfwa",
                  "mgfwa", "fwassp"}));
  EXPECT_EQ(rows[1]["cells"][5]["other"], 14.6);
}

}  // namespace
}  // namespace ricochet::studies
