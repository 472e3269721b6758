#include "src/studies/dynamics/study.h"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "src/report/markdown_page.h"
#include "src/report/report.h"
#include "src/report/text.h"

namespace ricochet::studies::dynamics {
namespace {

using testing::HasSubstr;

/// A tiny study, as it is read back from the disk.
const report::Results& tiny() {
  static const report::Results results = [] {
    report::Json data = json_of(results_of({48,
                                            5,
                                            {1, 1e-6, 1e2},
                                            {{6}, {1e12}},
                                            {{1e8, 1e12}, {1e-4, 1e-5}, {1e-4}},
                                            {{6}, 4, 1},
                                            {2, 100, 2, 1},
                                            {9, {0, 1}, 1e10, 1},
                                            {{"C1", "C2"}, 2, 9, {1e14}, {1e-6}, {1e-3}}}));
    data["made"] = {{"version", "0"},
                    {"compiler", "none"},
                    {"threads", 1},
                    {"seconds", 1.0},
                    {"date", "2031-02-03"}};
    return report::results_of(report::data_in(report::json_text(data)));
  }();
  return results;
}

const report::Results& reference() {
  static const report::Results results = [] {
    std::ifstream stream(RICOCHET_SOURCE "/reports/reference/dynamics/data.json");
    return report::results_of(report::data_in({std::istreambuf_iterator<char>(stream), {}}));
  }();
  return results;
}

std::string text(const report::Results& results, const char* name) {
  return text_of(*results.value(name));
}

TEST(DynamicsStudy, FillsItsPageAndDrawsItsCharts) {
  const auto page = report::page_source(report::page_template("dynamics"));
  const report::PageFiles written = page_files(page, tiny());
  EXPECT_TRUE(written.failures.empty());
  for (const char* chart :
       {"levels.svg", "fidelity.svg", "restitution.svg", "mild-work.svg", "very-stiff-work.svg",
        "thresholds.svg", "grazes.svg", "semi-implicit-euler-stability.svg", "stability-cost.svg",
        "lyapunov-digits.svg", "lyapunov-courses.svg"}) {
    EXPECT_TRUE(written.files.contains(chart)) << chart;
  }
  for (const Table& table : tiny().tables) {
    EXPECT_FALSE(table.rows.empty()) << table.name;
  }
  EXPECT_THAT(written.files.at("summary.md"), HasSubstr("## Is the motion chaotic?"));
  EXPECT_EQ(tiny().parts.at("scene").size(), 7U);
  EXPECT_THAT(terminal_text(page, tiny()), HasSubstr("Hunt-Crossley's law returns 0.516."));
}

/// The share that fails stands beside the one that does not.
TEST(DynamicsStudy, SaysHowManyAgreeAndHowManyDoNot) {
  const Row walls = (*tiny().table("walls"))[0];
  EXPECT_EQ(walls.number("compared") + walls.number("unfinished"), 12);
  EXPECT_LE(walls.number("equal"), walls.number("compared"));
  EXPECT_THAT(text(tiny(), "walls"),
              HasSubstr("agree with hard ones in " + text_of(walls["equal"]) + " of 12 counts"));
  EXPECT_THAT(text(tiny(), "accuracy"), HasSubstr("of 28 pairs of method and scene"));
  EXPECT_THAT(text(tiny(), "thresholds-finding"), HasSubstr(" do not. The cheapest is "));
}

TEST(DynamicsStudy, KeepsFailuresOnTheChart) {
  for (const report::Part& part : tiny().parts.at("scene")) {
    const report::Chart& chart = *part.results.chart("work");
    const double rail = chart.lines.at(0).position;
    EXPECT_LT(rail, chart.y.range->upper);
    std::size_t points = 0;
    for (const report::Series& series : chart.series) {
      points += series.samples.size();
      for (const report::Sample& sample : series.samples) EXPECT_LE(*sample.value, rail);
    }
    const bool hard = part.id.find("stiff") == std::string::npos;
    EXPECT_EQ(points, 4U * 4 + (hard ? 3 : 2) * 2) << part.id;
  }
}

TEST(DynamicsStudy, CountsTheFailureModesOfEveryMethod) {
  const Table& modes = *tiny().table("failure-modes");
  ASSERT_EQ(modes.rows.size(), 16U);
  each_row(modes, [](const Row& row) {
    EXPECT_EQ(row.number("failed") == 0, row.text("method") == "event-driven");
  });
}

/// What the page states of the committed study, beside the values that it is filled with.
TEST(DynamicsStudy, OfTheReferenceHoldsWhatThePageSays) {
  each_row(*reference().table("restitution"), [](const Row& law) {
    EXPECT_LT(law.number("measurement_error"), 1e-6) << law.text("law");
    if (law.text("law") == "hunt-crossley") {
      EXPECT_GT(law.number("of_a_tenth"), 0.5);
    }
  });
  EXPECT_EQ(text(reference(), "faithful"), "kelvin-voigt, exact-restitution");
  // A right count costs fixed steps more and more, methods with a tolerance little.
  each_row(*reference().table("stability"), [](const Row& method) {
    EXPECT_EQ(method.number("growth") > 100, method.number_if("bound").has_value())
        << method.text("method");
  });
  // Impacts need smaller steps than a spring.
  each_row(*reference().table("stability"), [](const Row& method) {
    if (const auto bound = method.number_if("bound")) {
      EXPECT_LT(method.number("lowest_bad"), *bound);
    }
  });
  EXPECT_EQ(reference().table("thresholds")->rows.front()[0], Value("event-driven"));
  EXPECT_THAT(text(reference(), "chaos-finding"), HasSubstr("0 of 216 motions"));
}

}  // namespace
}  // namespace ricochet::studies::dynamics
