#include <fmt/format.h>

#include <cmath>

#include "src/studies/dynamics/sections.h"

namespace ricochet::studies::dynamics {
namespace {

using report::Mark;
using report::Scale;

/// A symbol a cell, and the border that linear theory draws.
report::Figure map_figure(const StabilityStudy& study, const StabilityMap& map) {
  const auto& stiffnesses = study.plan.stiffnesses;
  report::Chart chart;
  chart.name = "stability-" + map.method;
  chart.title = map.method + " on walls that give way";
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
  return {std::move(chart),
          bound ? fmt::format("Every symbol is a run. The line is where the step h times the "
                              "frequency w of the wall is {:.3g}: above it theory calls {} "
                              "unstable on a spring.",
                              *bound, map.method)
                : "Every symbol is a run. The method chooses its steps by the tolerance."};
}

report::Figure cost_figure(const StabilityStudy& study) {
  report::Chart chart;
  chart.name = "stability-cost";
  chart.title = "What a right count costs";
  chart.x = {"stiffness of the walls [N/m^1.5]", Scale::logarithmic};
  chart.y = {"evaluations of the force per impact", Scale::logarithmic};
  for (const StabilityMap& map : study.maps) {
    report::Series series{map.method, Mark::line, {}};
    for (std::size_t s = 0; s < map.cells.size(); ++s) {
      const auto cell = cheapest_right(map.cells[s]);
      series.samples.push_back(
          {study.plan.stiffnesses[s], cell ? std::optional(cell->evaluations) : std::nullopt});
    }
    chart.series.push_back(std::move(series));
  }
  chart.width = 640;
  chart.height = 360;
  return {std::move(chart),
          "At the loosest control from which on all tighter ones count right. A line ends where no "
          "control tried is tight enough."};
}

report::Figure return_figure(const StabilityStudy& study) {
  report::Chart chart;
  chart.name = "stability-return";
  chart.title = "How much faster an elastic wall can return a body";
  chart.x = {"step times frequency of the wall, h w"};
  chart.y = {"speed after over speed before", Scale::logarithmic};
  for (const ReturnCurve& curve : study.returns) {
    report::Series series{
        fmt::format("{}, force ~ depth^{}", curve.method, curve.exponent), Mark::line, {}};
    for (const Return& point : curve.returns) {
      series.samples.push_back({point.scaled_step, point.ratio});
    }
    chart.series.push_back(std::move(series));
  }
  chart.lines = {{report::Direction::vertical, 2, "bounds of theory, 2 and 2.83"},
                 {report::Direction::vertical, std::sqrt(8.0), "bounds of theory, 2 and 2.83"}};
  chart.width = 720;
  chart.height = 360;
  return {std::move(chart),
          fmt::format("One impact of a body that no other force disturbs: in truth the ratio is 1. "
                      "The worst of {} phases of the step at the wall.",
                      study.plan.phases)};
}

report::Figure rest_figure(const StabilityStudy& study) {
  report::Chart chart;
  chart.name = "stability-rest";
  chart.title = "What it costs to come to rest on a wall";
  chart.x = {"stiffness of the wall [N/m^1.5]", Scale::logarithmic};
  chart.y = {"evaluations of the force", Scale::logarithmic};
  for (const RestCost& cost : study.rests) {
    report::Series series{cost.method, Mark::line, {}};
    for (std::size_t s = 0; s < cost.rests.size(); ++s) {
      const Rest& rest = cost.rests[s];
      series.samples.push_back({study.plan.stiffnesses[s],
                                rest.depth_error ? std::optional(rest.evaluations) : std::nullopt});
    }
    chart.series.push_back(std::move(series));
  }
  chart.width = 640;
  chart.height = 360;
  return {std::move(chart),
          fmt::format("1 kg, pressed with 10 N onto a damped wall for {} s, tolerance {:.0e}.",
                      rest_seconds, rest_tolerance)};
}

}  // namespace

std::vector<report::Figure> stability_charts(const StabilityStudy& study) {
  std::vector<report::Figure> figures, adaptive;
  for (const StabilityMap& map : study.maps) {
    (spring_bound(map.method) ? figures : adaptive).push_back(map_figure(study, map));
  }
  figures.push_back(return_figure(study));
  figures.push_back(cost_figure(study));
  figures.push_back(rest_figure(study));
  figures.insert(figures.end(), adaptive.begin(), adaptive.end());
  return figures;
}

}  // namespace ricochet::studies::dynamics
