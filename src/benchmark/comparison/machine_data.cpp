#include "src/studies/contest/machine_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "src/studies/contest/machine_results.h"

namespace ricochet::studies::contest {
namespace {

using report::Json;

constexpr std::size_t mapped_competitors = 4;
constexpr int landscape_points = 25;  // of a box

using Factors = std::map<std::string, std::vector<double>>;

/// The machine's place: "restitution 0.1, friction 0.4", from the factor given on.
std::string row_name(const Question& question, Factors::const_iterator factor,
                     const Factors& factors) {
  std::string name;
  for (; factor != factors.end(); ++factor) {
    name += fmt::format("{}{} {}", name.empty() ? "" : ", ", factor->first,
                        level_name(factor->first, question.factors.at(factor->first)));
  }
  return name;
}

/// Rows of cells, one for each machine; several questions of one machine give their mean.
Json map_rows(const std::vector<MachineResult>& results, const Factors& factors,
              const std::function<double(const MachineResult&)>& value) {
  const auto& [column, levels] = *factors.begin();
  struct Cell {
    double sum = 0;
    int questions = 0;
  };
  std::map<std::vector<double>, std::pair<std::string, std::vector<Cell>>> rows;
  for (const MachineResult& result : results) {
    std::vector<double> place;
    for (auto factor = std::next(factors.begin()); factor != factors.end(); ++factor) {
      place.push_back(result.question->factors.at(factor->first));
    }
    auto& [name, cells] = rows[place];
    name = row_name(*result.question, std::next(factors.begin()), factors);
    cells.resize(levels.size());
    const auto level = std::find(levels.begin(), levels.end(), result.question->factors.at(column));
    Cell& cell = cells[static_cast<std::size_t>(level - levels.begin())];
    cell.sum += value(result);
    ++cell.questions;
  }
  Json all = Json::array();
  for (const auto& [place, row] : rows) {
    Json cells = Json::array();
    for (const Cell& cell : row.second) {
      cells.push_back(cell.questions > 0 ? Json(cell.sum / cell.questions) : Json());
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

/// What the best known value of a question is for people: a speed is maximised.
double best_known(const MachineResult& result) {
  return std::abs(result.question->stated.best_known.value_or(0));
}

Json columns_of(const Factors& factors) {
  const auto& [factor, levels] = *factors.begin();
  Json columns = Json::array();
  for (const double level : levels) columns.push_back({{"level", level_name(factor, level)}});
  return columns;
}

/// What the best competitors solve: a map each.
void add_solved(Json& maps, const std::string& family, const ByCompetitor& competitors,
                const Factors& factors) {
  const auto order = best_first(competitors);
  for (std::size_t k = 0; k < std::min(mapped_competitors, order.size()); ++k) {
    maps.push_back({{"family", family},
                    {"column", factors.begin()->first},
                    {"columns", columns_of(factors)},
                    {"number", k + 1},
                    {"competitor", name_of(*order[k])},
                    {"share", mean_solved(order[k]->second)},
                    {"rows", map_rows(order[k]->second, factors,
                                      [](const MachineResult& r) { return r.solved; })}});
  }
}

/// Of the competitor that takes most questions, and so knows most machines.
const std::vector<MachineResult>& widest(const ByCompetitor& competitors) {
  return std::max_element(
             competitors.begin(), competitors.end(),
             [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); })
      ->second;
}

/// What questions of one variable, without constraints, are truly worth over their box: a row a
/// machine.
void add_landscape(Json& landscapes, const std::string& family, const ByCompetitor& competitors,
                   const Factors& factors) {
  const std::vector<MachineResult>& machines = widest(competitors);
  const Problem& first = machines.front().question->stated;
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
      cells.push_back(truth_at(machine.question->stated, point(k)).objective);
    }
    rows.push_back({{"machine", row_name(*machine.question, factors.begin(), factors)},
                    {"cells", std::move(cells)}});
  }
  landscapes.push_back(
      {{"family", family},
       {"axis", variable.unit.empty() ? variable.name
                                      : fmt::format("{} [{}]", variable.name, variable.unit)},
       {"columns", std::move(columns)},
       {"rows", std::move(rows)},
       {"value_label", family.starts_with("count") ? "collisions" : "objective"}});
}

Json family_data(const std::string& family, const ByCompetitor& competitors,
                 const Factors& factors) {
  const auto order = best_first(competitors);
  const bool is_speed = family.starts_with("top-speed");
  Json known = map_rows(widest(competitors), factors, best_known);
  const Json range = extent(known);
  return {
      {"family", family},
      {"column", factors.begin()->first},
      {"columns", columns_of(factors)},
      {"known_label", is_speed ? "fastest quiet speed [rad/s]" : "best known value"},
      {"known_title", fmt::format("{}: {:.3g} to {:.3g}{}", family, range["least"].get<double>(),
                                  range["most"].get<double>(), is_speed ? " rad/s" : "")},
      {"known", std::move(known)},
      {"first", name_of(*order.front())},
      {"first_share", mean_solved(order.front()->second)}};
}

}  // namespace

Json machine_data(const Campaign& campaign, const std::vector<StoredStanding>& standings,
                  const std::vector<ReportedPart>& parts) {
  Json machines = Json::array();
  Json maps = Json::array();
  Json landscapes = Json::array();
  for (const ReportedPart& part : parts) {
    if (campaign.plan().parts[part.part].machines.around.empty()) continue;  // no grid
    for (const auto& [family, competitors] : machine_results(campaign, standings, part)) {
      const Factors factors = factors_of(competitors);
      if (factors.size() < 2) continue;
      machines.push_back(family_data(family, competitors, factors));
      add_solved(maps, family, competitors, factors);
      add_landscape(landscapes, family, competitors, factors);
    }
  }
  return {{"machines", std::move(machines)},
          {"machine_maps", std::move(maps)},
          {"landscapes", std::move(landscapes)}};
}

}  // namespace ricochet::studies::contest
