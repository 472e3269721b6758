#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/gradients/trust.h"
#include "src/report/chart_data.h"
#include "src/studies/surrogate/charts.h"
#include "src/studies/surrogate/grazes.h"

namespace ricochet::studies::surrogate {
namespace {

using carrier_track::short_reach;
using report::Json;
using report::Mark;

report::Chart chart_over_distance(std::string name, std::string y) {
  return large_chart(std::move(name),
                     {"distance from the graze, share of 18 rad/s", report::Scale::logarithmic},
                     {std::move(y), report::Scale::logarithmic});
}

/// Of the first graze of each case that something follows.
Json slopes_of(const GrazeStudy& study, std::size_t width) {
  report::Chart chart = chart_over_distance(fmt::format("graze-slopes-{}", width + 1),
                                            "|slope of the surrogate| [impacts per rad/s]");
  report::Series missed{"the wall is missed, all", Mark::points, {}};
  std::string shown;
  for (const GrazeRow& row : study.rows) {
    if (!row.followed() || row.id == shown) continue;
    shown = row.id;
    report::Series hit{
        fmt::format("{} at {:.3f} rad/s, hit", row.id, row.graze.omega), Mark::line, {}};
    for (const Approach& a : row.approaches[width]) {
      if (a.hit_slope != 0) hit.samples.push_back({a.distance, std::abs(a.hit_slope)});
      if (a.missed_slope != 0) missed.samples.push_back({a.distance, std::abs(a.missed_slope)});
    }
    std::reverse(hit.samples.begin(), hit.samples.end());
    add(chart, std::move(hit));
  }
  add(chart, std::move(missed));
  Json data = report::data_of(chart);
  data["smoothing"] = study.plan.widths[width];
  return data;
}

Json reaches_of(const GrazeStudy& study) {
  report::Chart chart = chart_over_distance("graze-reach", "reach told, share of 18 rad/s");
  report::Series hit{"the wall is hit", Mark::points, {}};
  report::Series missed{"the wall is missed", Mark::points, {}};
  for (const GrazeRow& row : study.rows) {
    for (const Approach& a : row.approaches.front()) {
      if (std::isfinite(a.hit_reach)) hit.samples.push_back({a.distance, a.hit_reach});
      if (std::isfinite(a.missed_reach)) missed.samples.push_back({a.distance, a.missed_reach});
    }
  }
  const double near = study.plan.distances.back();
  const double far = study.plan.distances.front();
  chart.series = {{"reach = distance", Mark::line, {{near, near}, {far, far}}},
                  std::move(hit),
                  std::move(missed)};
  chart.lines = {{report::Direction::horizontal, short_reach, "in doubt below"}};
  return report::data_of(chart);
}

Json data_of(const GrazeRow& row) {
  Json exponents = Json::array();
  for (const auto& exponent : row.exponents) exponents.push_back(exponent);
  const Approach& nearest = row.approaches.front().back();
  return {{"id", row.id},
          {"omega", row.graze.omega},
          {"wall", row.graze.wall == carrier_track::Wall::upper ? "upper" : "lower"},
          {"hit", row.graze.side > 0 ? "above" : "below"},
          {"exponents", std::move(exponents)},
          {"reach_hit", nearest.hit_reach / nearest.distance},
          {"reach_missed", nearest.missed_reach / nearest.distance}};
}

}  // namespace

Json data_of(const GrazeStudy& study) {
  Json rows = Json::array();
  std::size_t followed = 0;
  double least = 0;
  double most = -1e300;
  double steepest = 0;
  double missed = 0;
  double reach_error = 0;  // from 1e-6 of the range on
  for (const GrazeRow& row : study.rows) {
    rows.push_back(data_of(row));
    for (const Approach& a : row.approaches.front()) {
      if (a.distance > 1.01e-6) continue;
      reach_error = std::max({reach_error, std::abs(a.hit_reach / a.distance - 1),
                              std::abs(a.missed_reach / a.distance - 1)});
    }
    if (!row.followed()) continue;
    ++followed;
    for (const auto& exponent : row.exponents) {
      least = std::min(least, exponent.value_or(least));
      most = std::max(most, exponent.value_or(most));
    }
    for (const auto& approaches : row.approaches) {
      steepest = std::max(steepest, std::abs(approaches.back().hit_slope));
      missed = std::max(missed, std::abs(approaches.back().missed_slope));
    }
  }
  if (followed == 0) return nullptr;
  Json slopes = Json::array();
  for (std::size_t w = 0; w < study.plan.widths.size(); ++w) slopes.push_back(slopes_of(study, w));
  return {{"right", std::abs(least + 0.5) < 0.05 && std::abs(most + 0.5) < 0.05},
          {"followed", followed},
          {"all", rows.size()},
          {"least", least},
          {"most", most},
          {"narrowest", study.plan.widths.back()},
          {"widest", study.plan.widths.front()},
          {"nearest", study.plan.distances.back()},
          {"steepest", steepest},
          {"missed", missed},
          {"reach_error", reach_error},
          {"short_reach", short_reach},
          {"widths", study.plan.widths},
          {"rows", std::move(rows)},
          {"slopes", std::move(slopes)},
          {"reaches", reaches_of(study)}};
}

}  // namespace ricochet::studies::surrogate
