#include <fmt/format.h>

#include <numeric>

#include "src/studies/dynamics/sections.h"

namespace ricochet::studies::dynamics {
namespace {

std::string name_of(double direction) {
  return fmt::format("{:.2f}", direction);
}

double percent(int part, int whole) {
  return whole > 0 ? 100.0 * part / whole : 0.0;
}

/// Where x alone counts wrong.
report::Figure map_of(const LevelStudy& study) {
  report::Chart chart;
  chart.name = "levels";
  chart.title = "Speeds at which one direction is not enough [%]";
  chart.x.label = "pull across over pull along, tan phi";
  chart.y.label = "case";
  report::HeatMap map{"wrong counts [%]", {}, report::Range{0, 100}};
  for (const double d : study.plan.directions) chart.x.categories.push_back(name_of(d));
  for (const LevelRow& row : study.rows) {
    chart.y.categories.push_back(row.id);
    auto& cells = map.rows.emplace_back();
    for (const int wrong : row.wrong) cells.emplace_back(percent(wrong, row.speeds));
  }
  chart.heat_map = std::move(map);
  chart.height = 420;
  return {chart,
          "Share of the speeds at which a model of x alone counts otherwise than one of x and y. "
          "The yarn pulls the carrier across, friction grows with its press on the wall there."};
}

report::Table certainty_table(const LevelStudy& study) {
  report::Table table{
      "Hard walls, one direction: counts that are certain, and why others are not. "
      "Resolved: certain on compliant walls, which auto then takes.",
      {{"case", report::Alignment::left},
       {"speeds"},
       {"certain [%]"},
       {"a margin"},
       {"the window"},
       {"a graze"},
       {"sensitive"},
       {"resolved"}},
      {}};
  for (const LevelRow& row : study.rows) {
    std::vector<report::Cell> cells = {{row.id},
                                       {fmt::format("{}", row.speeds)},
                                       {fmt::format("{:.2f}", percent(row.certain, row.speeds))}};
    for (std::size_t doubt = 1; doubt < row.doubts.size(); ++doubt) {
      cells.push_back({fmt::format("{}", row.doubts[doubt])});
    }
    cells.push_back({fmt::format("{}", row.resolved)});
    table.rows.push_back(std::move(cells));
  }
  return table;
}

report::Table cost_table(const LevelStudy& study) {
  report::Table table{"Processor time of a count over that of hard walls in one direction.",
                      {{"case", report::Alignment::left}, {"compliant"}, {"planar"}, {"auto"}},
                      {}};
  for (const LevelRow& row : study.rows) {
    std::vector<report::Cell> cells = {{row.id}};
    for (const std::size_t level : {1, 2, 3}) {
      cells.push_back({fmt::format("{:.1f}", row.seconds[level] / row.seconds[0])});
    }
    table.rows.push_back(std::move(cells));
  }
  return table;
}

}  // namespace

report::Section levels_section(const LevelStudy& study) {
  report::Section section{"levels", "How much of the model does a scene need?"};
  int speeds = 0;
  int certain = 0;
  int resolved = 0;
  std::vector<int> coupled(study.plan.directions.size());
  std::vector<int> wrong = coupled;
  for (const LevelRow& row : study.rows) {
    speeds += row.speeds;
    certain += row.certain;
    resolved += row.resolved;
    for (std::size_t d = 0; d < coupled.size(); ++d) {
      coupled[d] += row.coupled[d];
      wrong[d] += row.wrong[d];
    }
  }
  std::string across;
  for (std::size_t d = 0; d < coupled.size(); ++d) {
    across += fmt::format("{}{:.0f} % at tan phi = {} (wrong without: {:.0f} %)", d > 0 ? ", " : "",
                          percent(coupled[d], speeds), name_of(study.plan.directions[d]),
                          percent(wrong[d], speeds));
  }
  section.paragraphs = {
      fmt::format("Found: hard walls in one direction give a certain count at {} of {} speeds of "
                  "the twelve cases ({:.2f} %); of the {} others compliant walls settle {}. Both "
                  "directions are needed only where the yarn pulls across harder than friction "
                  "holds: {}.",
                  certain, speeds, percent(certain, speeds), speeds - certain, resolved, across),
      fmt::format(
          "The levels, cheapest first: hard walls (impact), walls that give way (compliant, here "
          "with stiffness {:.1e} N/m^1.5 and the law exact-restitution), and both directions of "
          "the clearance (planar). Fidelity auto takes the cheapest whose count is certain. A "
          "count is certain if changing every constant in the tenth digit leaves every collision "
          "where it is; else its reason is told: a speed at the limit from which it counts, an "
          "impact at the end of the window, a wall just touched or missed, or a motion too "
          "sensitive. The paper does not give the yarn's direction nor the clearance across: "
          "here it is that of x.",
          study.plan.stiffness)};
  section.tables = {certainty_table(study), cost_table(study)};
  section.figures = {map_of(study)};
  return section;
}

}  // namespace ricochet::studies::dynamics
