#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/report/text.h"
#include "src/studies/dynamics/sections.h"

namespace ricochet::studies::dynamics {
namespace {

std::string name_of(double stiffness) {
  return fmt::format("1e{:.0f}", std::log10(stiffness));
}

report::Figure map_of(const FidelityStudy& fidelity) {
  report::Chart chart;
  chart.name = "fidelity";
  chart.title = "Speeds with equal counts [%]";
  chart.x.label = "stiffness [N/m^1.5]";
  chart.y.label = "case";
  report::HeatMap map{"equal [%]", {}, report::Range{0, 100}};
  for (const double stiffness : fidelity.plan.stiffnesses) {
    chart.x.categories.push_back(name_of(stiffness));
  }
  for (std::size_t c = fidelity.cases.size(); c-- > 0;) {  // from below
    chart.y.categories.push_back(fidelity.cases[c]);
    auto& row = map.rows.emplace_back();
    for (const FidelityCell& cell : fidelity.cells[c]) {
      const auto share = cell.share();
      row.push_back(share ? std::optional(100 * *share) : std::nullopt);
    }
  }
  chart.heat_map = std::move(map);
  chart.height = 420;
  return {chart,
          "100: at every speed tried. Hatched: no compliant "
          "simulation came through."};
}

/// All cases with one stiffness.
struct Total {
  int equal = 0, distance = 0, compared = 0, tried = 0;
  std::optional<double> least, most;  // cost of a case
};

Total total_of(const FidelityStudy& fidelity, std::size_t s) {
  Total total;
  for (const auto& row : fidelity.cells) {
    total.equal += row[s].equal;
    total.distance += row[s].distance;
    total.compared += row[s].compared;
    total.tried += static_cast<int>(fidelity.plan.speeds.size());
    if (!row[s].cost) continue;
    total.least = std::min(total.least.value_or(*row[s].cost), *row[s].cost);
    total.most = std::max(total.most.value_or(*row[s].cost), *row[s].cost);
  }
  return total;
}

}  // namespace

report::Section fidelity_section(const FidelityStudy& fidelity) {
  report::Section section{"fidelity", "Does it matter whether a wall is hard?"};
  report::Table table{
      "All cases together. Cost: processor time of the compliant simulation over that of the hard "
      "one, of the cheapest and the dearest case.",
      {{"stiffness [N/m^1.5]"},
       {"counts compared"},
       {"equal"},
       {"share"},
       {"apart on average"},
       {"not finished"},
       {"cost, least"},
       {"cost, most"}},
      {}};
  std::string found;
  for (std::size_t s = 0; s < fidelity.plan.stiffnesses.size(); ++s) {
    const Total total = total_of(fidelity, s);
    const std::string share =
        total.compared > 0 ? fmt::format("{:.0f} %", 100.0 * total.equal / total.compared) : "–";
    table.rows.push_back(
        {{name_of(fidelity.plan.stiffnesses[s])},
         {fmt::format("{}", total.compared)},
         {fmt::format("{}", total.equal)},
         {share},
         {total.compared > 0 ? fmt::format("{:.2f}", 1.0 * total.distance / total.compared) : "–"},
         {fmt::format("{}", total.tried - total.compared)},
         {report::text_or_dash(total.least, "{:.1f}")},
         {report::text_or_dash(total.most, "{:.1f}")}});
    found += fmt::format("{}{} with stiffness {}", s > 0 ? ", " : "", share,
                         name_of(fidelity.plan.stiffnesses[s]));
  }
  section.paragraphs = {
      fmt::format("Found: of the counts of hard walls these shares are those of compliant ones, "
                  "too: {}. Where they differ, either the penetration matters, or the motion is so "
                  "sensitive that any difference would show.",
                  found),
      fmt::format(
          "A hard wall turns the velocity round in no time; a compliant one takes a time and a "
          "depth, which shrink as it stiffens. Every case of the paper is counted by both at {} "
          "speeds from {} to {} rad/s, with the law exact-restitution, so that both lose the same "
          "in an impact, and with the exponent 1.5 of Hertz. Hertz's stiffness 4/3 E* "
          "sqrt(R) is 1.5e10 N/m^1.5 for steel on steel and a radius of 10 mm; the others show how "
          "the limit of a hard wall is approached.",
          fidelity.plan.speeds.size(), fidelity.plan.speeds.front(), fidelity.plan.speeds.back())};
  section.tables = {std::move(table)};
  section.figures = {map_of(fidelity)};
  return section;
}

}  // namespace ricochet::studies::dynamics
