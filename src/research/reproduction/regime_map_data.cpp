#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>

#include "problems/carrier_track/advice/regime_map_chart.h"
#include "problems/carrier_track/regimes/regime_map.h"
#include "src/research/reproduction/data.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;
using advice::MapMarks;
using report::Json;

constexpr double least = 0.05, most = 0.95;  // restitution
constexpr int values = 31;

Json areas_of(const report::Chart& chart) {
  return report::list_of(chart.areas, [](const report::Area& area) {
    return Json{{"label", area.label},
                {"name", area.name},
                {"shade", report::as_json(area.shade)},
                {"parts", report::list_of(area.parts, [](const auto& part) {
                   return report::list_of(part, [](const report::Area::Edge& edge) {
                     return Json::array({edge.position, edge.between.lower, edge.between.upper});
                   });
                 })}};
  });
}

Json series_of(const report::Chart& chart) {
  return report::list_of(chart.series, [](const report::Series& series) {
    return Json{{"label", series.label},
                {"mark", series.mark == report::Mark::points ? "points" : "line"},
                {"samples", report::list_of(series.samples, [](const report::Sample& sample) {
                   return Json{{"x", sample.position},
                               {"y", report::as_json(sample.value)},
                               {"name", sample.name}};
                 })}};
  });
}

/// The map of the machine of `cases`, which differ in their restitution alone.
RestitutionMap map_of(const std::vector<const CaseStudy*>& cases) {
  MapMarks marks;
  std::vector<QuietCase> quiet;
  for (const CaseStudy* c : cases) {
    const std::string& id = c->the_case.id;
    quiet.push_back({id, c->borders.quiet});
    if (const auto threshold = c->the_case.claim.threshold) {
      marks.thresholds.push_back(
          {c->the_case.restitution, *threshold, fmt::format("{}: {:.4g}", id, *threshold)});
    }
  }
  return {cases.front()->the_case.friction, std::move(quiet),
          regime_map(cases.front()->scene, {"restitution", least, most, values}), marks};
}

Json json_of(const RestitutionMap& shown) {
  const report::Chart chart = advice::regime_map_chart(shown.map, "", {}, shown.marks);
  return {{"friction", shown.friction},
          {"cases", report::as_json(shown.cases)},
          {"least", least},
          {"most", most},
          {"fastest", shown.map.options.speeds.to},
          {"areas", areas_of(chart)},
          {"series", series_of(chart)}};
}

}  // namespace

std::vector<RestitutionMap> restitution_maps(const std::vector<CaseStudy>& cases) {
  std::map<double, std::vector<const CaseStudy*>> machines;  // by friction
  for (const CaseStudy& c : cases) {
    if (c.the_case.disturbance == 0) machines[c.the_case.friction].push_back(&c);
  }
  std::vector<RestitutionMap> maps;
  for (const auto& [friction, of_it] : machines) maps.push_back(map_of(of_it));
  return maps;
}

Json regime_map_data(const std::vector<RestitutionMap>& maps) {
  if (maps.empty()) return {};
  return {{"maps", report::list_of(maps, json_of)}};
}

}  // namespace ricochet::studies::reproduction
