#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "problems/carrier_track/scene/scene_fields.h"
#include "src/analysis/comparison/order.h"
#include "src/analysis/comparison/sections.h"

namespace ricochet::studies::comparison {

namespace {

using report::Chart;
using report::HeatMap;
using report::Range;

constexpr int landscape_points = 25;  // per edge of a box

/// Factors with their levels.
using Factors = std::map<std::string, std::set<double>>;

/// The factors of these machines that have several levels. None if there are no more machines than
/// such factors: they could not be distinguished.
Factors factors_of(const std::vector<const Problem*>& problems) {
  Factors factors;
  std::set<std::string> machines;
  for (const Problem* problem : problems) {
    machines.insert(problem->machine);
    for (const auto& [name, value] : problem->factors) factors[name].insert(value);
  }
  std::erase_if(factors, [](const auto& factor) { return factor.second.size() < 2; });
  return machines.size() > factors.size() ? factors : Factors();
}

/// The machine's coordinates: "restitution 0.1, friction 0.4", from the given factor on. A level of
/// fidelity stands alone: "compliant, friction 0.1".
std::string row_name(const Problem& problem, Factors::const_iterator factor,
                     const Factors& factors) {
  std::string name;
  for (; factor != factors.end(); ++factor) {
    if (!name.empty()) name += ", ";
    if (factor->first != "fidelity") name += factor->first + " ";
    name += level_name(factor->first, problem.factors.at(factor->first));
  }
  return name;
}

/// The variable, if the problem maximises it.
std::optional<Variable> maximised_in(const Problem& problem) {
  const bool is_maximised = problem.dimension() == 1 && problem.variables.size() == 1 &&
                            problem.best_point && problem.best_known == -(*problem.best_point)[0];
  return is_maximised ? std::optional(problem.variables.front()) : std::nullopt;
}

std::string label_of(const Variable& variable) {
  return variable.unit.empty() ? variable.name
                               : fmt::format("{} [{}]", variable.name, variable.unit);
}

/// The least and the largest cell of a map.
Range extent(const HeatMap& map) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const auto& row : map.rows) {
    for (const auto& cell : row) {
      if (cell) range = {std::min(range.lower, *cell), std::max(range.upper, *cell)};
    }
  }
  return range;
}

/// The best known values, as a user reads them: a column for each level of the first factor, a row
/// for each combination of the others; several problems of one machine are averaged.
Chart known_map(const std::string& family, std::vector<const Problem*> problems,
                const Factors& factors) {
  std::ranges::stable_sort(problems, {}, &Problem::factors);
  const auto& [column, levels] = *factors.begin();
  const auto maximised = maximised_in(*problems.front());
  Table values{"values", {{"row"}, {"level"}, {"value"}}};
  for (const Problem* problem : problems) {
    values.add(row_name(*problem, std::next(factors.begin()), factors), problem->factors.at(column),
               std::abs(problem->best_known.value_or(0)));
  }
  const Table means = aggregated(values, {"row", "level"}, {{{"value"}, "value", mean_of}});
  const Table rows = aggregated(values, {"row"}, {});
  Chart chart{
      .name = "known",
      .x = {column},
      .y = {""},
      .heat_map = HeatMap{maximised ? "largest " + label_of(*maximised) : "best known value"}};
  for (const double level : levels) chart.x.categories.push_back(level_name(column, level));
  for (std::size_t i = rows.rows.size(); i-- > 0;) {  // from the bottom
    chart.y.categories.push_back(rows[i].text("row"));
    auto& cells = chart.heat_map->rows.emplace_back();
    for (const double level : levels) {
      const auto mean = means.find([&](const Row& row) {
        return row["row"] == rows[i]["row"] && row.number("level") == level;
      });
      cells.push_back(mean ? mean->number_if("value") : std::nullopt);
    }
  }
  const Range range = extent(*chart.heat_map);
  chart.title = fmt::format("{}: best known values of {:.3g} to {:.3g}{}", family, range.lower,
                            range.upper, maximised ? " " + maximised->unit : "");
  chart.height = 150 + 18 * static_cast<int>(rows.rows.size());
  return chart;
}

/// The true objective over the box, a row for each machine, for problems of one variable without
/// constraints.
std::optional<Chart> landscape(const std::string& family,
                               const std::vector<const Problem*>& problems,
                               const Factors& factors) {
  const Problem& first = *problems.front();
  if (first.dimension() != 1 || first.constraints > 0) return {};
  const Variable variable = first.variables.empty() ? Variable{"x", ""} : first.variables.front();
  const auto point = [&](int k) {
    return Vector::Constant(
        1, first.lower[0] + (first.upper[0] - first.lower[0]) * k / (landscape_points - 1));
  };
  Chart chart{.name = "landscape",
              .x = {label_of(variable)},
              .y = {""},
              .heat_map = HeatMap{first.source.empty() ? "objective" : first.source}};
  for (int k = 0; k < landscape_points; ++k) {
    chart.x.categories.push_back(fmt::format("{:.3g}", point(k)[0]));
  }
  for (auto problem = problems.rbegin(); problem != problems.rend(); ++problem) {
    chart.y.categories.push_back(row_name(**problem, factors.begin(), factors));
    auto& cells = chart.heat_map->rows.emplace_back();
    for (int k = 0; k < landscape_points; ++k) {
      cells.emplace_back(true_values_at(**problem, point(k)).objective);
    }
  }
  const Range range = extent(*chart.heat_map);
  chart.title = fmt::format("{}: {:.3g} to {:.3g} over the machines and the {}", family,
                            range.lower, range.upper, chart.x.label);
  chart.width = 820;
  chart.height = 160 + 16 * static_cast<int>(problems.size());
  return chart;
}

}  // namespace

report::Results machines_page(const std::vector<RatedPart>& parts) {
  report::Results page;
  each_group(parts, [&](const RatedPart& rated, std::size_t g) {
    const Campaign& campaign = *rated.comparison.campaign;
    const Group& group = rated.groups[g];
    if (campaign.plan().parts[rated.part->part].machines.around.empty()) return;
    std::vector<const Problem*> problems;
    for (const std::size_t q : group.problems) {
      if (!campaign.problems()[q].factors.empty()) problems.push_back(&campaign.problems()[q]);
    }
    const Factors factors = factors_of(problems);
    if (factors.empty()) return;
    report::Part part{group.family, group.family, {}};
    part.results.set("family", group.family);
    if (factors.size() > 1) {
      part.results.add(known_map(group.family, problems, factors));
      if (auto chart = landscape(group.family, problems, factors))
        part.results.add(std::move(*chart));
    }
    part.results.add(level_table(rated.comparison, group));
    page.add("families", std::move(part));
  });
  return page;
}

std::string level_name(const std::string& factor, double level) {
  if (factor != "fidelity") return fmt::format("{}", level);
  using carrier_track::Fidelity;
  return std::string(carrier_track::name_of(carrier_track::fidelity_names(),
                                            static_cast<Fidelity>(std::lround(level))));
}

}  // namespace ricochet::studies::comparison
