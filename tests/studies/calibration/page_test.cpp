#include "src/studies/calibration/page.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/studies/calibration/some_search.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

RankedFit ranked(const Reading& reading, std::vector<Open> freed, double misfit) {
  Fit fit{reading, std::move(freed), natural_constants(), misfit, ""};
  fit.constants[static_cast<std::size_t>(Open::pull)] = 1;
  Appraisal appraisal = appraise(fit, 1.0);
  return {std::move(fit), std::move(appraisal)};
}

/// A study that nobody made: the page has to stand whatever it says.
Study some_study() {
  Study study;
  study.plan.search = some_search(1);
  Reading other;
  other.tension = Tension::rotating;
  study.readings = {ranked(Reading{}, open_of(Reading{}), 20), ranked(other, open_of(other), 30)};
  study.frontier = {ranked(Reading{}, {Open::pull, Open::slowest, Open::phase}, 20),
                    ranked(Reading{}, {Open::pull, Open::slowest}, 21)};
  study.chosen = 1;
  study.rankings = {{some_search(2), {Reading{}}, {22.5}, 0.75}};
  study.predictions = {{"C1", 9, 8.5}, {"C2", 2, std::nullopt}};
  study.sensitivities = {{"C1", {0.5, std::nullopt}}, {"C2", {-1, 2}}};
  study.profiles = {{Open::pull, 1, 0.5, 2, false, true, {{0.5, 22}, {1, 21}, {2, 21.5}}},
                    {Open::slowest, 0.01, 0.009, 0.02, false, false, {{0.009, 22}, {0.01, 21}}}};
  return study;
}

TEST(Page, HasTablesAndChartsThatHoldTogether) {
  const report::Page page = page_of(some_study());
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
  EXPECT_EQ(charts, (std::set<std::string>{"error-against-freedom", "sensitivity", "profile-pull",
                                           "profile-slowest"}));
}

TEST(Page, SaysWhichConstantIsHeldNextAndAtWhat) {
  const report::Page page = page_of(some_study());
  for (const report::Section& section : page.sections) {
    if (section.id != "frontier") continue;
    EXPECT_EQ(section.tables[0].rows[0][1].text, "none");
    EXPECT_EQ(section.tables[0].rows[1][1].text, "phase = 0 rad");
  }
}

TEST(Page, LeavesOutWhatAStudyOfOneReadingDoesNotHave) {
  Study study = some_study();
  study.readings.pop_back();
  study.rankings.clear();
  std::set<std::string> ids;
  for (const report::Section& section : page_of(study).sections) ids.insert(section.id);
  EXPECT_FALSE(ids.contains("readings"));
  EXPECT_FALSE(ids.contains("answers"));
  EXPECT_FALSE(ids.contains("rankings"));
}

}  // namespace
}  // namespace ricochet::studies::calibration
