#include "src/studies/dynamics/study.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "src/report/page_template.h"
#include "src/report/report.h"

namespace ricochet::studies::dynamics {
namespace {

using report::Json;
using report::Section;
using report::Table;

/// What a tiny study leaves on the disk, read back.
const Json& data() {
  static const Json kept = [] {
    Json data = {{"report", "dynamics"},
                 {"made", {{"version", "0"}, {"compiler", "none"}, {"seconds", 1.0}}}};
    data.update(results_of({48,
                            5,
                            {1, 1e-6, 1e2},
                            {{6}, {1e12}},
                            {{1e8, 1e12}, {1e-4, 1e-5}, {1e-4}, 4},
                            {{6}, 4, {5}, 1},
                            {2, 100, 2, 1},
                            {9, {0, 1}, 1e10, 1},
                            {{"C1", "C2"}, 2, 9, {1e14}, {1e-6}, {1e-3}}}));
    return Json::parse(data.dump());
  }();
  return kept;
}

const report::DrawnPage& drawing() {
  static const report::DrawnPage page = report::drawn(report::page_template("dynamics"), data());
  return page;
}

const Section& section(const std::string& id) {
  for (const Section& section : drawing().page.sections) {
    if (section.id == id) return section;
  }
  throw std::invalid_argument("there is no section " + id);
}

/// Expects that the numbers of a column are those of the data.
void expect_column(const Table& table, std::size_t column, const Json& rows, const char* key,
                   const char* form, double scale = 1) {
  ASSERT_FALSE(rows.empty());
  ASSERT_EQ(table.rows.size(), rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const Json& value = rows[r].at(key);
    EXPECT_EQ(table.rows[r].at(column).text,
              value.is_null() ? "–" : fmt::format(fmt::runtime(form), scale * value.get<double>()))
        << table.columns[column].title << ", row " << r;
  }
}

TEST(DynamicsStudy, ShowsTheNumbersOfItsData) {
  const Json& laws = data()["restitution"]["laws"];
  const Table& restitution = section("restitution").tables.at(0);
  expect_column(restitution, 1, laws, "worst_asked", "{:.2f}");
  expect_column(restitution, 4, laws, "of_a_tenth", "{:.3f}");
  const Json& mild = data()["scenes"][0]["methods"];
  expect_column(section("work-mild").tables.at(0), 5, mild, "error", "{:.1e}");
  expect_column(section("stability").tables.at(0), 2, data()["stability"]["borders"], "lowest_bad",
                "{:.2f}");
  const Table& courses = section("lyapunov").tables.at(0);
  expect_column(courses, 1, data()["lyapunov"]["courses"], "digits_an_impact", "{:.3f}");
  expect_column(section("fidelity").tables.at(0), 2, data()["fidelity"]["stiffnesses"], "equal",
                "{:.0f}");
  const Table& levels = section("levels").tables.at(0);
  expect_column(levels, 2, data()["levels"]["cases"], "certain", "{:.2f}", 100);
  expect_column(section("thresholds").tables.at(0), 5, data()["thresholds"]["simulations"], "error",
                "{:.1e}");
}

TEST(DynamicsStudy, SaysOfEveryMethodHowItFails) {
  const Json& controls = data()["failure_modes"]["controls"];
  const auto& tables = section("hazards").tables;
  ASSERT_EQ(tables.size(), 2U);
  for (std::size_t c = 0; c < 2; ++c) {
    const Json& methods = controls[c]["methods"];
    ASSERT_EQ(tables[c].rows.size(), 8U);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const auto& row = tables[c].rows[m];
      ASSERT_EQ(row.size(), 7U);
      std::size_t failed = 0;
      for (std::size_t mode = 1; mode < row.size(); ++mode) {
        EXPECT_NE(row[mode].state, report::State::neutral) << row[0].text;
        EXPECT_FALSE(row[mode].text.empty()) << row[0].text;
        failed += row[mode].state == report::State::bad ? 1 : 0;
      }
      EXPECT_EQ(failed == 0, row[0].text == "event-driven") << row[0].text;
    }
  }
  EXPECT_EQ(data()["failure_modes"]["flawless"], Json::array({"event-driven"}));
}

TEST(DynamicsStudy, DrawsEveryChartOfItsData) {
  std::size_t charts = 0;
  for (const Section& section : drawing().page.sections) {
    for (const report::Figure& figure : section.figures) {
      EXPECT_NO_THROW(report::check(figure.chart)) << figure.chart.name;
      EXPECT_FALSE(figure.chart.title.empty()) << figure.chart.name;
      EXPECT_FALSE(figure.caption.empty()) << figure.chart.name;
      ++charts;
    }
  }
  EXPECT_EQ(charts, 1U + 5 + 9 + 2 + 1 + 3 + 2 + 1);
}

TEST(DynamicsStudy, BeginsEverySectionWithWhatItFound) {
  ASSERT_EQ(drawing().page.sections.size(), 16U);
  for (const Section& section : drawing().page.sections) {
    if (section.id == "origin") continue;
    if (section.paragraphs.at(0).starts_with(drawing().headline.finding)) continue;
    EXPECT_EQ(section.paragraphs.at(0).rfind("Found: ", 0), 0U) << section.id;
  }
}

TEST(DynamicsStudy, KeepsFailuresOnTheChart) {
  ASSERT_EQ(data()["scenes"].size(), 7U);
  for (const Json& scene : data()["scenes"]) {
    const report::Chart& chart =
        section("work-" + scene["id"].get<std::string>()).figures.at(0).chart;
    const double rail = chart.lines.at(0).position;
    EXPECT_LT(rail, chart.y.range->upper);
    std::size_t points = 0;
    for (const report::Series& series : chart.series) {
      points += series.samples.size();
      for (const report::Sample& sample : series.samples) EXPECT_LE(*sample.value, rail);
    }
    const bool hard = chart.name.find("stiff") == std::string::npos;
    EXPECT_EQ(points, 4U * 4 + (hard ? 3 : 2) * 2) << chart.name;
  }
}

TEST(DynamicsStudy, CountsEveryCaseByHardAndCompliantWalls) {
  const Json& total = data()["fidelity"]["stiffnesses"].at(0);
  EXPECT_EQ(total["compared"].get<int>() + total["unfinished"].get<int>(), 12);
  EXPECT_LE(total["equal"], total["compared"]);
}

TEST(DynamicsStudy, IsDrawnAgainFromItsData) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "ricochet-dynamics-study";
  std::filesystem::remove_all(folder);
  const report::WrittenReport written = report::write_report(data(), folder / "one");
  EXPECT_EQ(written.epilogue,
            "8 contact laws, 8 methods in 5 scenes, 12 cases by hard and compliant walls");
  EXPECT_EQ(written.failures, std::vector<std::string>());
  EXPECT_EQ(report::redraw_report(folder / "one", folder / "two").epilogue, written.epilogue);
  const auto text = [](const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "one")) {
    const auto other = folder / "two" / entry.path().filename();
    EXPECT_EQ(text(entry.path()), text(other)) << other;
    ++files;
  }
  // The page and its summary, the data, the manifest, a file for every chart and every table.
  EXPECT_EQ(files, 4U + 24 + 21);
}

}  // namespace
}  // namespace ricochet::studies::dynamics
