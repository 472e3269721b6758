#include <gtest/gtest.h>

#include <regex>
#include <stdexcept>

#include "src/report/drawing.h"
#include "src/report/svg.h"

namespace ricochet::report {
namespace {

Chart linked_map() {
  return {.name = "map",
          .title = "Map",
          .x = {.categories = {"hs", "top"}},
          .y = {.categories = {"solver b", "solver a"}},
          .heat_map = HeatMap{.label = "share [%]",
                              .rows = {{100, 0}, {50, std::nullopt}},
                              .row_links = {"view#entry=b", "view#entry=a"},
                              .column_links = {"&family=hs", "&family=top"}}};
}

TEST(CellLinks, AreThoseOfRowAndColumn) {
  const Json data = cell_links_data(linked_map());
  EXPECT_EQ(data["rows"].dump(),
            R"x([["solver a","view/index.html#entry=a"],["solver b","view/index.html#entry=b"]])x")
      << "from the top";
  EXPECT_EQ(data["columns"].dump(), R"x([["hs","&family=hs"],["top","&family=top"]])x");
}

TEST(CellLinks, LieOverTheCells) {
  const Chart chart = linked_map();
  const Json box = cell_links_data(chart)["box"];
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
  Chart chart = linked_map();
  chart.heat_map->row_links = {"view", "view"};
  EXPECT_THROW(cell_links_data(chart), std::invalid_argument) << "no state of the view";
  chart.heat_map->row_links = {"view#a"};
  EXPECT_THROW(cell_links_data(chart), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet::report
