#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/report/chart_data.h"
#include "src/studies/dynamics/stability.h"

namespace ricochet::studies::dynamics {
namespace {

using report::Json;
using report::Mark;
using report::Scale;

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

/// By how much the cheapest right count of a method is dearer on the stiffest walls than on the
/// softest; nothing if there is none.
std::optional<double> growth(const StabilityMap& map) {
  const auto soft = cheapest_right(map.cells.front());
  const auto stiff = cheapest_right(map.cells.back());
  if (!soft || !stiff) return std::nullopt;
  return stiff->evaluations / soft->evaluations;
}

/// A symbol a cell, and the border that linear theory draws.
Json map_data(const StabilityStudy& study, const StabilityMap& map) {
  const auto& stiffnesses = study.plan.stiffnesses;
  report::Chart chart;
  chart.name = "stability-" + map.method;
  chart.x = {"stiffness of the walls [N/m^1.5]", Scale::logarithmic,
             report::Range{stiffnesses.front() / 3, stiffnesses.back() * 3}};
  chart.y = {map.control, Scale::logarithmic,
             report::Range{map.controls.back() / 2, map.controls.front() * 2}};
  for (const Behaviour behaviour : all_behaviours()) {
    report::Series series{words_of(behaviour), Mark::points, {}};
    for (std::size_t s = 0; s < stiffnesses.size(); ++s) {
      for (std::size_t c = 0; c < map.controls.size(); ++c) {
        if (map.cells[s][c].behaviour == behaviour) {
          series.samples.push_back({stiffnesses[s], map.controls[c]});
        }
      }
    }
    chart.series.push_back(std::move(series));
  }
  const auto bound = spring_bound(map.method);
  if (bound) {
    report::Series border{fmt::format("h w = {:.3g}", *bound), Mark::line, {}};
    for (std::size_t s = 0; s < stiffnesses.size(); ++s) {
      const double step = *bound / study.frequencies[s];
      if (step < chart.y.range->upper) border.samples.push_back({stiffnesses[s], step});
    }
    chart.series.push_back(std::move(border));
  }
  chart.width = 640;
  chart.height = bound ? 460 : 340;
  Json data = report::data_of(chart);
  data["method"] = map.method;
  data["bound"] = bound;
  return data;
}

report::Chart cost_chart(const StabilityStudy& study) {
  report::Chart chart;
  chart.name = "stability-cost";
  chart.x = {"stiffness of the walls [N/m^1.5]", Scale::logarithmic};
  chart.y = {"evaluations of the force per impact", Scale::logarithmic};
  for (const StabilityMap& map : study.maps) {
    auto& series = chart.series.emplace_back(report::Series{map.method, Mark::line, {}});
    for (std::size_t s = 0; s < map.cells.size(); ++s) {
      const auto cell = cheapest_right(map.cells[s]);
      series.samples.push_back(
          {study.plan.stiffnesses[s], cell ? std::optional(cell->evaluations) : std::nullopt});
    }
  }
  chart.width = 640;
  chart.height = 360;
  return chart;
}

report::Chart return_chart(const StabilityStudy& study) {
  report::Chart chart;
  chart.name = "stability-return";
  chart.x = {"step times frequency of the wall, h w"};
  chart.y = {"speed after over speed before", Scale::logarithmic};
  for (const ReturnCurve& curve : study.returns) {
    auto& series = chart.series.emplace_back(report::Series{
        fmt::format("{}, force ~ depth^{}", curve.method, curve.exponent), Mark::line, {}});
    for (const Return& point : curve.returns) {
      series.samples.push_back({point.scaled_step, point.ratio});
    }
  }
  for (const double bound : {2.0, std::sqrt(8.0)}) {
    chart.lines.push_back({report::Direction::vertical, bound, "bounds of theory, 2 and 2.83"});
  }
  chart.width = 720;
  chart.height = 360;
  return chart;
}

report::Chart rest_chart(const StabilityStudy& study) {
  report::Chart chart;
  chart.name = "stability-rest";
  chart.x = {"stiffness of the wall [N/m^1.5]", Scale::logarithmic};
  chart.y = {"evaluations of the force", Scale::logarithmic};
  for (const RestCost& cost : study.rests) {
    auto& series = chart.series.emplace_back(report::Series{cost.method, Mark::line, {}});
    for (std::size_t s = 0; s < cost.rests.size(); ++s) {
      const Rest& rest = cost.rests[s];
      series.samples.push_back({study.plan.stiffnesses[s],
                                rest.depth_error ? std::optional(rest.evaluations) : std::nullopt});
    }
  }
  chart.width = 640;
  chart.height = 360;
  return chart;
}

Json data_of(const Rest& rest) {
  return {{"evaluations", rest.evaluations}, {"error", rest.depth_error}};
}

}  // namespace

Json data_of(const StabilityStudy& study) {
  Json data = {{"softest", study.plan.stiffnesses.front()},
               {"stiffest", study.plan.stiffnesses.back()},
               {"phases", study.plan.phases},
               {"rest_seconds", rest_seconds},
               {"rest_tolerance", rest_tolerance},
               {"hard",
                {{"method", study.hard.method},
                 {"right", right_counts(study.hard)},
                 {"steps", study.hard.controls.size()}}},
               {"return_chart", report::data_of(return_chart(study))},
               {"cost_chart", report::data_of(cost_chart(study))},
               {"rest_chart", report::data_of(rest_chart(study))}};
  for (const char* list : {"borders", "failing", "growths", "returns", "orders", "rests", "resting",
                           "restless", "fixed_maps", "adaptive_maps"}) {
    data[list] = Json::array();
  }
  int wrong = 0, runs = 0;
  for (const StabilityMap& map : study.maps) {
    data["growths"].push_back({{"method", map.method}, {"growth", growth(map)}});
    if (const auto bound = spring_bound(map.method)) {
      const Border border = border_of(map, study.frequencies);
      data["borders"].push_back({{"method", map.method},
                                 {"highest_good", border.highest_good},
                                 {"lowest_bad", border.lowest_bad},
                                 {"bound", *bound}});
      data["fixed_maps"].push_back(map_data(study, map));
      continue;
    }
    const int failed = runs_of(map) - right_counts(map);
    wrong += failed;
    runs += runs_of(map);
    if (failed > 0) data["failing"].push_back({{"method", map.method}, {"wrong", failed}});
    data["adaptive_maps"].push_back(map_data(study, map));
  }
  data["any_failing"] = wrong > 0;
  data["wrong"] = wrong;
  data["runs"] = runs;
  for (const ReturnCurve& curve : study.returns) {
    data["returns"].push_back(
        {{"method", curve.method}, {"exponent", curve.exponent}, {"onset", onset(curve, 1 / 0.9)}});
  }
  for (const EdgeOrder& order : study.orders) {
    data["orders"].push_back({{"wall", order.wall},
                              {"expected", order.expected},
                              {"measured", order.measured},
                              {"error", order.error}});
  }
  for (const RestCost& cost : study.rests) {
    const auto& error = cost.rests.back().depth_error;
    data[error && *error < 1e-9 ? "resting" : "restless"].push_back(cost.method);
    data["rests"].push_back({{"method", cost.method},
                             {"soft", data_of(cost.rests.front())},
                             {"stiff", data_of(cost.rests.back())}});
  }
  return data;
}

}  // namespace ricochet::studies::dynamics
