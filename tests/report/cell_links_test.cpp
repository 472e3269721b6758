#include <gtest/gtest.h>

#include <regex>
#include <stdexcept>

#include "src/report/page_template.h"
#include "src/report/svg.h"
#include "src/report/text.h"

namespace ricochet::report {
namespace {

const Json two_solvers = {
    {"map", {{{"solver", "a"}, {"shares", {0.5, nullptr}}}, {{"solver", "b"}, {"shares", {1, 0}}}}},
    {"families", {{{"family", "hs"}}, {{"family", "top"}}}}};

const toml::table linked_map = toml::parse(R"(
name = "map"
title = "Map"
x = { categories = "families", category = "{{family}}" }
y = { categories = "map", category = "solver {{solver}}", order = "down" }
heat_map = { cells = "shares", value = ".:%", row_link = "view#entry={{solver}}", column_link = "&family={{family}}" }
)");

TEST(CellLinks, AreThoseOfRowAndColumn) {
  const TemplatePart part(linked_map);
  const Json data =
      cell_links_data(chart_of(part, {&two_solvers}), cell_links_of(part, {&two_solvers}));
  EXPECT_EQ(data["rows"].dump(),
            R"x([["solver a","view/index.html#entry=a"],["solver b","view/index.html#entry=b"]])x")
      << "from the top";
  EXPECT_EQ(data["columns"].dump(), R"x([["hs","&family=hs"],["top","&family=top"]])x");
}

TEST(CellLinks, LieOverTheCells) {
  const TemplatePart part(linked_map);
  const Chart chart = chart_of(part, {&two_solvers});
  const Json box = cell_links_data(chart, cell_links_of(part, {&two_solvers}))["box"];
  // The upper right cell has no value: its hatched rectangle ends where the box does.
  const std::string svg = to_svg(chart);
  std::smatch found;
  const std::regex gap(R"x(hatching\)"[^>]* d="M([0-9.]+) ([0-9.]+)h([0-9.]+)v-([0-9.]+))x");
  ASSERT_TRUE(std::regex_search(svg, found, gap)) << svg;
  const double left = std::stod(found[1]), bottom = std::stod(found[2]);
  EXPECT_EQ(box[1], left + std::stod(found[3]));
  EXPECT_EQ(box[2], bottom - std::stod(found[4]));
  // Edges of cells are on whole pixels.
  EXPECT_NEAR(box[0].get<double>(), left - std::stod(found[3]), 1);
  EXPECT_NEAR(box[3].get<double>(), bottom + std::stod(found[4]), 1);
}

TEST(CellLinks, MustFitTheChart) {
  const Chart chart = chart_of(TemplatePart(linked_map), {&two_solvers});
  EXPECT_THROW(cell_links_data(chart, {{"view#a"}, {"&b", "&c"}}), std::invalid_argument);
  EXPECT_THROW(cell_links_data(chart, {{"view", "view"}, {"&b", "&c"}}), std::invalid_argument)
      << "no state of the view";
}

}  // namespace
}  // namespace ricochet::report
