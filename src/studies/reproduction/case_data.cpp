#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/report/chart_data.h"
#include "src/report/text.h"
#include "src/studies/reproduction/data.h"
#include "src/studies/reproduction/path_chart.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;
using report::Json;

Json relative_error(const std::optional<double>& computed, const std::optional<double>& paper) {
  return computed && paper ? Json(*computed / *paper - 1) : Json();
}

report::Chart chart_of_thresholds(const std::vector<CaseStudy>& cases) {
  report::Chart chart;
  chart.name = "thresholds";
  chart.x.label = "case";
  chart.y = {"threshold [rad/s]", report::Scale::logarithmic, report::Range{1, 20}};
  report::Series paper{"paper", report::Mark::points, {}};
  report::Series computed{"computed", report::Mark::points, {}};
  for (const CaseStudy& c : cases) {
    const auto position = static_cast<double>(chart.x.categories.size());
    chart.x.categories.push_back(c.the_case.id);
    paper.samples.push_back({position, c.the_case.claim.threshold});
    computed.samples.push_back({position, c.score.threshold});
  }
  chart.series = {paper, computed};
  chart.width = 640;
  return chart;
}

/// The staircase, with a sample only where it jumps.
std::vector<report::Sample> samples_of(const SpeedScan& scan) {
  std::vector<report::Sample> samples;
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    const bool last = k + 1 == scan.counts.size();
    if (k > 0 && !last && scan.counts[k] == scan.counts[k - 1]) continue;
    samples.push_back({scan.omega(k), scan.counts[k]});
  }
  return samples;
}

Json curve_of(const CaseStudy& c) {
  const Case& the_case = c.the_case;
  const SpeedScan shown = c.scan.step < 0.01 ? thinned(c.scan, 10) : c.scan;
  report::Chart chart;
  chart.name = "count-" + report::lower_case(the_case.id);
  chart.x = {"speed [rad/s]", report::Scale::linear, report::Range{0, 18}};
  const int most = *std::max_element(shown.counts.begin(), shown.counts.end());
  chart.y = {"collisions", report::Scale::linear, report::Range{0, 1.1 * most}};
  chart.series = {{"", report::Mark::steps, samples_of(shown)}};
  using report::Direction;
  // In this order, so that each line looks the same in every chart.
  chart.lines = {{Direction::horizontal, quiet_limit(c.score.quiet_count), "quiet up to here"}};
  if (c.score.threshold) {
    chart.lines.push_back({Direction::vertical, *c.score.threshold, "threshold"});
  }
  if (the_case.claim.threshold) {
    chart.lines.push_back({Direction::vertical, *the_case.claim.threshold, "paper's threshold"});
  }
  Json data = report::data_of(chart);
  data.update({{"id", the_case.id},
               {"restitution", the_case.restitution},
               {"friction", the_case.friction},
               {"disturbance", the_case.disturbance}});
  return data;
}

Json path_of(const CaseStudy& c, double omega, const char* side, const Recording& recording) {
  Scene scene = c.scene;
  scene.omega = omega;
  const int number = c.the_case.claim.figure->number;
  Json data =
      report::data_of(path_chart(scene, recording, fmt::format("path-{}-{}", number, side), ""));
  data.update({{"figure", number},
               {"id", c.the_case.id},
               {"omega", omega},
               {"count", recording.count},
               {"doubt", recording.certainty.certain ? "" : recording.certainty.reason}});
  return data;
}

/// Impacts that count, before and after the first tenth of a turn.
Json impacts_of(const CaseStudy& c, double omega, const Recording& recording) {
  const double end_of_start = 0.1 * 2 * std::numbers::pi / omega;
  int start = 0;
  int later = 0;
  for (const Impact& impact : recording.impacts) {
    if (impact.speed > c.scene.slowest) ++(impact.time < end_of_start ? start : later);
  }
  return {{"omega", omega}, {"start", start}, {"later", later}};
}

}  // namespace

Json case_data(const std::vector<CaseStudy>& cases) {
  Json by_id = Json::object();
  for (const CaseStudy& c : cases) {
    const Case& it = c.the_case;
    const Score& s = c.score;
    by_id[it.id] = {{"id", it.id},
                    {"restitution", it.restitution},
                    {"friction", it.friction},
                    {"disturbance", it.disturbance},
                    {"paper_threshold", it.claim.threshold},
                    {"threshold", s.threshold},
                    {"threshold_error", relative_error(s.threshold, it.claim.threshold)},
                    {"first_loud", s.first_loud},
                    {"paper_quiet_count", it.claim.quiet_count},
                    {"quiet_count", s.quiet_count},
                    {"quiet_count_error", relative_error(s.quiet_count, it.claim.quiet_count)},
                    {"misclassified", s.misclassified},
                    {"purity", s.purity},
                    {"loudness", s.loudness},
                    {"loud", s.loudness && *s.loudness >= 1.5}};
  }
  return by_id;
}

Json threshold_data(const std::vector<CaseStudy>& cases) {
  Json examples = Json::array();
  Json wrong = Json::array();
  for (const CaseStudy& c : cases) {
    if (!c.the_case.claim.figure) continue;
    Json row = {{"figure", c.the_case.claim.figure->number}, {"id", c.the_case.id}};
    for (const Example& e : c.score.examples) {
      const char* side = e.loud ? "loud" : "quiet";
      row[side] = {{"omega", e.omega}, {"count", e.count}, {"right", e.right}};
      if (e.right) continue;
      wrong.push_back(
          {{"id", c.the_case.id}, {"omega", e.omega}, {"count", e.count}, {"shown", side}});
    }
    row["quiet_up_to"] = std::floor(quiet_limit(c.score.quiet_count));
    examples.push_back(std::move(row));
  }
  return {{"examples", std::move(examples)},
          {"wrong", std::move(wrong)},
          {"chart", report::data_of(chart_of_thresholds(cases))}};
}

Json curve_data(const std::vector<CaseStudy>& cases) {
  Json curves = Json::array();
  for (const CaseStudy& c : cases) curves.push_back(curve_of(c));
  return curves;
}

Json path_data(const std::vector<CaseStudy>& cases) {
  Json impacts = Json::array();
  Json charts = Json::array();
  for (const CaseStudy& c : cases) {
    if (!c.paths) continue;
    const auto& [number, quiet, loud] = *c.the_case.claim.figure;
    charts.push_back(path_of(c, quiet, "quiet", c.paths->quiet));
    charts.push_back(path_of(c, loud, "loud", c.paths->loud));
    const auto& id = c.the_case.id;
    if (id != "C1" && id != "C2" && id != "C4") continue;
    impacts.push_back({{"id", id},
                       {"restitution", c.the_case.restitution},
                       {"friction", c.the_case.friction},
                       {"quiet", impacts_of(c, quiet, c.paths->quiet)},
                       {"loud", impacts_of(c, loud, c.paths->loud)}});
  }
  return {{"impacts", std::move(impacts)}, {"charts", std::move(charts)}};
}

}  // namespace ricochet::studies::reproduction
