#include <algorithm>
#include <utility>

#include "src/research/dynamics/stability.h"

namespace ricochet::studies::dynamics {
namespace {

using report::Json;

/// The words of a legend, and its order.
constexpr std::pair<Behaviour, const char*> behaviours[] = {
    {Behaviour::right_count, "right number of impacts"},
    {Behaviour::leaves_the_walls, "flies out through a wall"},
    {Behaviour::too_few, "impacts missed"},
    {Behaviour::gains_energy, "walls give energy"},
    {Behaviour::too_many, "too many impacts"},
    {Behaviour::gives_up, "gives up"}};

int right_counts(const StabilityMap& map) {
  int right = 0;
  for (const auto& row : map.cells) {
    right += static_cast<int>(
        std::ranges::count(row, Behaviour::right_count, &StabilityCell::behaviour));
  }
  return right;
}

int runs_of(const StabilityMap& map) {
  return static_cast<int>(map.cells.size() * map.controls.size());
}

int wrong_runs(const StabilityMap& map) {
  return runs_of(map) - right_counts(map);
}

/// Ratio of the cost of a method's cheapest right count on the stiffest and on the softest walls;
/// nothing if there is none.
std::optional<double> growth(const StabilityMap& map) {
  const auto soft = cheapest_right(map.cells.front());
  const auto stiff = cheapest_right(map.cells.back());
  if (!soft || !stiff) return std::nullopt;
  return stiff->evaluations / soft->evaluations;
}

/// The runs by behaviour, and the stability limit of linear theory.
Json map_data(const StabilityStudy& study, const StabilityMap& map) {
  const auto& stiffnesses = study.plan.stiffnesses;
  const auto bound = spring_bound(map.method);
  Json data = {{"method", map.method},
               {"control", map.control},
               {"bound", bound},
               {"runs", runs_of(map)},
               {"wrong", wrong_runs(map)},
               {"bottom", map.controls.back() / 2},
               {"top", map.controls.front() * 2},
               {"behaviours", Json::array()},
               {"border", Json::array()}};
  for (const auto& [behaviour, words] : behaviours) {
    Json runs = Json::array();
    for (std::size_t s = 0; s < stiffnesses.size(); ++s) {
      for (std::size_t c = 0; c < map.controls.size(); ++c) {
        if (map.cells[s][c].behaviour != behaviour) continue;
        runs.push_back({{"stiffness", stiffnesses[s]}, {"control", map.controls[c]}});
      }
    }
    data["behaviours"].push_back({{"behaviour", words}, {"runs", std::move(runs)}});
  }
  for (std::size_t s = 0; bound && s < stiffnesses.size(); ++s) {
    const double step = *bound / study.frequencies[s];
    if (step < data["top"])
      data["border"].push_back({{"stiffness", stiffnesses[s]}, {"step", step}});
  }
  return data;
}

/// Cost by stiffness.
template <class Evaluations>
Json costs_of(const StabilityStudy& study, const Evaluations& evaluations_of) {
  Json costs = Json::array();
  for (std::size_t s = 0; s < study.plan.stiffnesses.size(); ++s) {
    costs.push_back({{"stiffness", study.plan.stiffnesses[s]}, {"evaluations", evaluations_of(s)}});
  }
  return costs;
}

Json right_costs(const StabilityStudy& study, const StabilityMap& map) {
  return costs_of(study, [&](std::size_t s) {
    const auto cell = cheapest_right(map.cells[s]);
    return cell ? Json(cell->evaluations) : Json();
  });
}

Json rest_costs(const StabilityStudy& study, const RestCost& cost) {
  return costs_of(study, [&](std::size_t s) {
    return cost.rests[s].depth_error ? Json(cost.rests[s].evaluations) : Json();
  });
}

Json curve_of(const ReturnCurve& curve) {
  const auto point_of = [](const Return& point) -> Json {
    return {{"scaled_step", point.scaled_step}, {"ratio", point.ratio}};
  };
  return {{"method", curve.method},
          {"exponent", curve.exponent},
          {"onset", onset(curve, 1 / 0.9)},
          {"points", report::list_of(curve.returns, point_of)}};
}

Json data_of(const Rest& rest) {
  return {{"evaluations", rest.evaluations}, {"error", rest.depth_error}};
}

}  // namespace

Json data_of(const StabilityStudy& study) {
  const std::vector<double>& stiffnesses = study.plan.stiffnesses;
  Json data = {{"softest", stiffnesses.front()},
               {"stiffest", stiffnesses.back()},
               {"left", stiffnesses.front() / 3},
               {"right", stiffnesses.back() * 3},
               {"phases", study.plan.phases},
               {"rest_seconds", rest_seconds},
               {"rest_tolerance", rest_tolerance},
               {"hard",
                {{"method", study.hard.method},
                 {"right", right_counts(study.hard)},
                 {"steps", study.hard.controls.size()}}}};
  for (const char* list : {"borders", "failing", "growths", "rests", "resting", "restless",
                           "rest_costs", "fixed_maps", "adaptive_maps"}) {
    data[list] = Json::array();
  }
  int wrong = 0, runs = 0;
  for (const StabilityMap& map : study.maps) {
    data["growths"].push_back(
        {{"method", map.method}, {"growth", growth(map)}, {"costs", right_costs(study, map)}});
    if (const auto bound = spring_bound(map.method)) {
      const Border border = border_of(map, study.frequencies);
      data["borders"].push_back({{"method", map.method},
                                 {"highest_good", border.highest_good},
                                 {"lowest_bad", border.lowest_bad},
                                 {"bound", *bound}});
      data["fixed_maps"].push_back(map_data(study, map));
      continue;
    }
    const int failed = wrong_runs(map);
    wrong += failed;
    runs += runs_of(map);
    if (failed > 0) data["failing"].push_back({{"method", map.method}, {"wrong", failed}});
    data["adaptive_maps"].push_back(map_data(study, map));
  }
  data["any_failing"] = wrong > 0;
  data["wrong"] = wrong;
  data["runs"] = runs;
  data["returns"] = report::list_of(study.returns, curve_of);
  data["orders"] = report::list_of(study.orders, [](const EdgeOrder& order) -> Json {
    return {{"wall", order.wall},
            {"expected", order.expected},
            {"measured", order.measured},
            {"error", order.error}};
  });
  for (const RestCost& cost : study.rests) {
    const auto& error = cost.rests.back().depth_error;
    data[error && *error < 1e-9 ? "resting" : "restless"].push_back(cost.method);
    data["rest_costs"].push_back({{"method", cost.method}, {"costs", rest_costs(study, cost)}});
    data["rests"].push_back({{"method", cost.method},
                             {"soft", data_of(cost.rests.front())},
                             {"stiff", data_of(cost.rests.back())}});
  }
  return data;
}

}  // namespace ricochet::studies::dynamics
