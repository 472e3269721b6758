#include "src/studies/surrogate/study.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "src/report/page_template.h"
#include "src/report/report.h"

namespace ricochet::studies {
namespace {

using report::Json;

const Json& results() {
  static const Json made = [] {
    Json data = surrogate_study().compute(true);
    data["made"] = {{"version", "1.2.3"}, {"seconds", 4.5}};
    return data;
  }();
  return made;
}

const report::DrawnPage& drawing() {
  static const report::DrawnPage made =
      report::drawn(report::page_template("surrogate"), results());
  return made;
}

const report::Section& section(const std::string& id) {
  for (const report::Section& each : drawing().page.sections) {
    if (each.id == id) return each;
  }
  throw std::logic_error("no section " + id);
}

TEST(SurrogateStudy, FillsEverySectionWithChartsThatCanBeDrawn) {
  std::set<std::string> ids, charts;
  for (const report::Section& each : drawing().page.sections) {
    EXPECT_TRUE(ids.insert(each.id).second) << each.id;
    EXPECT_FALSE(each.paragraphs.empty()) << each.id;
    for (const report::Table& table : each.tables) EXPECT_FALSE(table.rows.empty()) << each.id;
    for (const report::Figure& figure : each.figures) {
      EXPECT_NO_THROW(report::check(figure.chart));
      EXPECT_TRUE(charts.insert(figure.chart.name).second) << figure.chart.name;
    }
  }
  EXPECT_EQ(ids, (std::set<std::string>{"gap", "guidance", "validity", "continuity", "growth",
                                        "agreement", "origin"}));
  EXPECT_EQ(section("gap").figures.size(), 2U);
  EXPECT_EQ(section("validity").figures.size(), 5U);
  EXPECT_EQ(drawing().epilogue.substr(0, 33), "12 cases at 3 smoothing parameter");
}

TEST(SurrogateStudy, ShowsTheNumbersOfItsData) {
  const auto expect_shown = [](const Json& number, const std::string& cell, double half_a_digit) {
    EXPECT_NEAR(number.get<double>(), std::stod(cell), half_a_digit) << cell;
  };
  const auto& bias = section("gap").tables.at(4).rows.at(1);
  const Json& smoothing = results()["bias"]["cases"][4]["smoothings"][1];
  expect_shown(smoothing["smoothing"], bias[0].text, 0);
  expect_shown(smoothing["error"], bias[1].text, 0.0005);
  EXPECT_EQ(bias[3].state,
            smoothing["count_optimality_gap"] == 0.0 ? report::State::good : report::State::bad);
  const auto& quality = section("validity").tables.at(0).rows.at(0);
  EXPECT_NEAR(100 * results()["gradient_doubt"]["smoothings"][0]["agreeing"].get<double>(),
              std::stod(quality[2].text), 0.05);
  const auto& motion = section("growth").tables.at(0).rows.at(12);
  EXPECT_EQ(results()["growth"]["motions"][12]["motion"], motion[0].text);
  expect_shown(results()["growth"]["motions"][12]["growth"], motion[2].text, 0.005);
  const auto& derivatives = section("agreement").tables.at(0).rows.back();
  EXPECT_EQ(derivatives[10].text, results()["derivative_check"]["all"]["unexplained"].dump());
  EXPECT_EQ(section("guidance").tables.at(0).rows.back()[1].text,
            std::to_string(
                std::lround(100 * results()["continuation"]["columns"][0]["share"].get<double>())) +
                " %");
}

}  // namespace
}  // namespace ricochet::studies
