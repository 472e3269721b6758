#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
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

using report::Json;

constexpr std::size_t mapped_entries = 4;
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

/// Returns rows of cells, one for each machine; several problems of one machine are averaged.
Json map_rows(const std::vector<MachineResult>& results, const Factors& factors,
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
    auto& [name, cells] = rows[place];
    name = row_name(*result.problem, std::next(factors.begin()), factors);
    cells.resize(levels.size());
    const auto level = std::find(levels.begin(), levels.end(), result.problem->factors.at(column));
    Cell& cell = cells[static_cast<std::size_t>(level - levels.begin())];
    cell.sum += value(result);
    ++cell.problems;
  }
  Json all = Json::array();
  for (const auto& [place, row] : rows) {
    Json cells = Json::array();
    for (const Cell& cell : row.second) {
      cells.push_back(cell.problems > 0 ? Json(cell.sum / cell.problems) : Json());
    }
    all.push_back({{"machine", row.first}, {"cells", std::move(cells)}});
  }
  return all;
}

Json extent(const Json& rows) {
  Json least, most;
  for (const Json& row : rows) {
    for (const Json& cell : row["cells"]) {
      if (cell.is_null()) continue;
      if (least.is_null() || cell < least) least = cell;
      if (most.is_null() || cell > most) most = cell;
    }
  }
  return {{"least", least}, {"most", most}};
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

Json columns_of(const Factors& factors) {
  const auto& [factor, levels] = *factors.begin();
  Json columns = Json::array();
  for (const double level : levels) columns.push_back({{"level", level_name(factor, level)}});
  return columns;
}

/// Adds a map of the share solved for each of the best entries.
void add_solved(Json& maps, const std::string& family, const ByEntry& entries,
                const Factors& factors) {
  const auto order = best_first(entries);
  for (std::size_t k = 0; k < std::min(mapped_entries, order.size()); ++k) {
    maps.push_back({{"family", family},
                    {"column", factors.begin()->first},
                    {"columns", columns_of(factors)},
                    {"number", k + 1},
                    {"entry", name_of(*order[k])},
                    {"share", mean_solved(order[k]->second)},
                    {"rows", map_rows(order[k]->second, factors,
                                      [](const MachineResult& r) { return r.solved; })}});
  }
}

/// Returns the results of the entry that takes most problems, and so covers most machines.
const std::vector<MachineResult>& widest(const ByEntry& entries) {
  return std::max_element(
             entries.begin(), entries.end(),
             [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); })
      ->second;
}

/// Adds the true objective over the box, a row for each machine, for problems of one variable
/// without constraints.
void add_landscape(Json& landscapes, const std::string& family, const ByEntry& entries,
                   const Factors& factors) {
  const std::vector<MachineResult>& machines = widest(entries);
  const Problem& first = *machines.front().problem;
  if (first.dimension() != 1 || first.constraints > 0) return;
  const Variable variable = first.variables.empty() ? Variable{"x", ""} : first.variables.front();
  const auto point = [&](int k) {
    return Vector::Constant(
        1, first.lower[0] + (first.upper[0] - first.lower[0]) * k / (landscape_points - 1));
  };
  Json columns = Json::array();
  for (int k = 0; k < landscape_points; ++k) {
    columns.push_back({{"at", fmt::format("{:.3g}", point(k)[0])}});
  }
  Json rows = Json::array();
  for (const MachineResult& machine : machines) {
    Json cells = Json::array();
    for (int k = 0; k < landscape_points; ++k) {
      cells.push_back(true_values_at(*machine.problem, point(k)).objective);
    }
    rows.push_back({{"machine", row_name(*machine.problem, factors.begin(), factors)},
                    {"cells", std::move(cells)}});
  }
  const Json range = extent(rows);
  landscapes.push_back({{"family", family},
                        {"least", range["least"]},
                        {"most", range["most"]},
                        {"axis", label_of(variable)},
                        {"columns", std::move(columns)},
                        {"rows", std::move(rows)},
                        {"value_label", first.source.empty() ? "objective" : first.source}});
}

Json family_data(const std::string& family, const ByEntry& entries, const Factors& factors) {
  const auto order = best_first(entries);
  const auto maximised = maximised_in(*widest(entries).front().problem);
  Json known = map_rows(widest(entries), factors, best_known);
  const Json range = extent(known);
  return {{"family", family},
          {"column", factors.begin()->first},
          {"columns", columns_of(factors)},
          {"known_label", maximised ? "largest " + label_of(*maximised) : "best known value"},
          {"known_title", fmt::format("{}: best known values of {:.3g} to {:.3g}{}", family,
                                      range["least"].get<double>(), range["most"].get<double>(),
                                      maximised ? " " + maximised->unit : "")},
          {"known", std::move(known)},
          {"first", name_of(*order.front())},
          {"first_share", mean_solved(order.front()->second)}};
}

}  // namespace

Json machine_data(const Campaign& campaign, const std::vector<CellResult>& results,
                  const std::vector<ReportedPart>& parts) {
  Json machines = Json::array();
  Json maps = Json::array();
  Json landscapes = Json::array();
  for (const ReportedPart& part : parts) {
    if (campaign.plan().parts[part.part].machines.around.empty()) continue;  // not a grid
    for (const auto& [family, entries] : machine_results(campaign, results, part)) {
      const Factors factors = factors_of(entries);
      if (factors.size() < 2) continue;
      machines.push_back(family_data(family, entries, factors));
      add_solved(maps, family, entries, factors);
      add_landscape(landscapes, family, entries, factors);
    }
  }
  return {{"machines", std::move(machines)},
          {"machine_maps", std::move(maps)},
          {"landscapes", std::move(landscapes)}};
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
