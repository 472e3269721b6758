#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "problems/carrier_track/scene/scene_fields.h"
#include "src/analysis/comparison/sections.h"
#include "src/analysis/rating.h"

namespace ricochet::studies::comparison {

namespace {

using report::Chart;
using report::HeatMap;
using report::Range;

constexpr double all_solved = 0.995;  // a map of it would be one colour
constexpr int landscape_points = 25;  // per edge of a box

using Factors = std::map<std::string, std::vector<double>>;

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

/// A map over machines: a column for each level of the first factor, a row for each combination of
/// the others; several problems of one machine are averaged.
Chart map_of(const std::string& name, const std::string& label,
             const std::vector<MachineResult>& results, const Factors& factors,
             const std::function<double(const MachineResult&)>& value) {
  const auto& [column, levels] = *factors.begin();
  struct Cell {
    double sum = 0;
    int problems = 0;
  };
  std::map<std::vector<double>, std::pair<std::string, std::vector<Cell>>> rows;
  for (const MachineResult& result : results) {
    std::vector<double> place;
    for (auto factor = std::next(factors.begin()); factor != factors.end(); ++factor) {
      place.push_back(result.problem->factors.at(factor->first));
    }
    auto& [row, cells] = rows[place];
    row = row_name(*result.problem, std::next(factors.begin()), factors);
    cells.resize(levels.size());
    const auto level = std::find(levels.begin(), levels.end(), result.problem->factors.at(column));
    Cell& cell = cells[static_cast<std::size_t>(level - levels.begin())];
    cell.sum += value(result);
    ++cell.problems;
  }
  Chart chart{.name = name, .x = {column}, .y = {""}, .heat_map = HeatMap{label}};
  for (const double level : levels) chart.x.categories.push_back(level_name(column, level));
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {  // from the bottom
    chart.y.categories.push_back(row->second.first);
    auto& cells = chart.heat_map->rows.emplace_back();
    for (const Cell& cell : row->second.second) {
      cells.push_back(cell.problems > 0 ? std::optional(cell.sum / cell.problems) : std::nullopt);
    }
  }
  chart.height = 150 + 18 * static_cast<int>(rows.size());
  return chart;
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

/// Returns the best known value as a user reads it: a maximised speed has its sign reversed.
double best_known(const MachineResult& result) {
  return std::abs(result.problem->best_known.value_or(0));
}

/// Returns the variable if the problem maximises it.
std::optional<Variable> maximised_in(const Problem& problem) {
  const bool is_maximised = problem.dimension() == 1 && problem.variables.size() == 1 &&
                            problem.best_point && problem.best_known == -(*problem.best_point)[0];
  return is_maximised ? std::optional(problem.variables.front()) : std::nullopt;
}

std::string label_of(const Variable& variable) {
  return variable.unit.empty() ? variable.name
                               : fmt::format("{} [{}]", variable.name, variable.unit);
}

/// Returns the results of the entry that takes most problems, and so covers most machines.
const std::vector<MachineResult>& widest(const ByEntry& entries) {
  return std::max_element(
             entries.begin(), entries.end(),
             [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); })
      ->second;
}

/// The true objective over the box, a row for each machine, for problems of one variable without
/// constraints.
std::optional<Chart> landscape(const std::string& family,
                               const std::vector<MachineResult>& machines, const Factors& factors) {
  const Problem& first = *machines.front().problem;
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
  for (auto machine = machines.rbegin(); machine != machines.rend(); ++machine) {
    chart.y.categories.push_back(row_name(*machine->problem, factors.begin(), factors));
    auto& cells = chart.heat_map->rows.emplace_back();
    for (int k = 0; k < landscape_points; ++k) {
      cells.emplace_back(true_values_at(*machine->problem, point(k)).objective);
    }
  }
  const Range range = extent(*chart.heat_map);
  chart.title = fmt::format("{}: {:.3g} to {:.3g} over the machines and the {}", family,
                            range.lower, range.upper, chart.x.label);
  chart.width = 820;
  chart.height = 160 + 16 * static_cast<int>(machines.size());
  return chart;
}

}  // namespace

void add_machine_maps(const std::string& family, const ByEntry& entries, report::Results& page) {
  const Factors factors = factors_of(entries);
  if (factors.size() < 2) return;
  const std::vector<MachineResult>& machines = widest(entries);
  const auto maximised = maximised_in(*machines.front().problem);
  Chart known = map_of("known", maximised ? "largest " + label_of(*maximised) : "best known value",
                       machines, factors, best_known);
  const Range range = extent(*known.heat_map);
  known.title = fmt::format("{}: best known values of {:.3g} to {:.3g}{}", family, range.lower,
                            range.upper, maximised ? " " + maximised->unit : "");
  const auto& first = *best_first(entries).front();
  const double share = mean_solved(first.second);
  page.set("finding",
           fmt::format("{}; {} solves most ({:.0f} %).", known.title, name_of(first), 100 * share));
  page.add(std::move(known));
  Chart solved = map_of("solved", "solved [%]", first.second, factors,
                        [](const MachineResult& r) { return 100 * r.solved; });
  solved.heat_map->range = Range{0, 100};
  solved.title =
      fmt::format("{}: {} solves {:.0f} % of the runs", family, name_of(first), 100 * share);
  if (share < all_solved) page.add(std::move(solved));
  if (auto chart = landscape(family, machines, factors)) page.add(std::move(*chart));
}

namespace {

MachineResult result_of(const Problem& problem, const CellResult& of_cell) {
  MachineResult result{&problem};
  const Outcomes& outcomes = of_cell.outcomes;
  for (const Outcome& outcome : outcomes) {
    result.solved += outcome.solved() ? 1 : 0;
    result.cost += std::log10(
        static_cast<double>(std::max<std::int64_t>(1, evaluations_until_solved(outcome))));
    result.accuracy += share_reached(*of_cell.targets, outcome.optimality_gap());
  }
  const auto runs = static_cast<double>(outcomes.size());
  result.solved /= runs;
  result.cost /= runs;
  result.accuracy /= runs;
  return result;
}

}  // namespace

std::map<std::string, ByEntry> machine_results(const Campaign& campaign,
                                               const std::vector<CellResult>& results,
                                               const ReportedPart& part) {
  const std::int64_t budget = campaign.plan().parts[part.part].budgets.back();
  std::map<std::string, ByEntry> families;
  for (const CellResult& s : results) {
    const Cell& cell = s.cell->cell;
    const Problem& problem = campaign.problems()[s.cell->problem];
    const auto& asked = s.cell->parts;
    const bool counts = std::find(asked.begin(), asked.end(), part.part) != asked.end() &&
                        !problem.factors.empty() && cell.perturbation == part.usual.perturbation &&
                        cell.gradient_price == part.usual.gradient_price && cell.budget == budget;
    if (!counts) continue;
    const std::string& family = part.families.at(campaign.family_of(s.cell->problem));
    families[family][{cell.solver, cell.formulation}].push_back(result_of(problem, s));
  }
  return families;
}

std::map<std::string, std::vector<double>> factors_of(const ByEntry& entries) {
  std::map<std::string, std::set<double>> found;
  std::set<std::string> machines;
  for (const auto& [entry, results] : entries) {
    for (const MachineResult& result : results) {
      machines.insert(result.problem->machine);
      for (const auto& [name, value] : result.problem->factors) found[name].insert(value);
    }
  }
  std::map<std::string, std::vector<double>> factors;
  for (const auto& [name, levels] : found) {
    if (levels.size() > 1) factors[name] = {levels.begin(), levels.end()};
  }
  if (machines.size() <= factors.size()) factors.clear();
  return factors;
}

double mean_solved(const std::vector<MachineResult>& results) {
  double sum = 0;
  for (const MachineResult& result : results) sum += result.solved;
  return sum / static_cast<double>(results.size());
}

std::vector<const ByEntry::value_type*> best_first(const ByEntry& entries) {
  std::vector<const ByEntry::value_type*> order;
  for (const auto& entry : entries) order.push_back(&entry);
  std::stable_sort(order.begin(), order.end(), [](const auto* a, const auto* b) {
    return mean_solved(a->second) > mean_solved(b->second);
  });
  return order;
}

std::string name_of(const ByEntry::value_type& c) {
  return entry(c.first.first, c.first.second);
}

std::string level_name(const std::string& factor, double level) {
  if (factor != "fidelity") return fmt::format("{}", level);
  using carrier_track::Fidelity;
  return std::string(carrier_track::name_of(carrier_track::fidelity_names(),
                                            static_cast<Fidelity>(std::lround(level))));
}

}  // namespace ricochet::studies::comparison
