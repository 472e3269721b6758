#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/questions/speed_range.h"
#include "src/core/problem.h"
#include "src/report/chart_data.h"
#include "src/studies/surrogate/gradient_doubt.h"

namespace ricochet::studies::surrogate {
namespace {

using carrier_track::fastest_speed;
using report::Json;

/// Shares of the points, but `trending` is a share of those that have a trend.
Json data_of(const GradientQuality& q) {
  const auto share = [](int part, int whole) {
    return whole > 0 ? Json(static_cast<double>(part) / whole) : Json();
  };
  const auto doubted = [&](GradientDoubt doubt) {
    return share(q.doubts[static_cast<std::size_t>(doubt)], q.points);
  };
  return {{"points", q.points},
          {"agreeing", share(q.agreeing, q.points)},
          {"flat", doubted(GradientDoubt::flat)},
          {"kink", doubted(GradientDoubt::kink)},
          {"sensitive", doubted(GradientDoubt::sensitive)},
          {"trending", share(q.right, q.trending)},
          {"reach", std::pow(10.0, q.log_reach)},
          {"log_reach", q.log_reach}};
}

/// A map over cases and speeds of what data_of names so, in percent if it is a share.
Json map_of(const GradientDoubtStudy& study, std::string name, std::string label, const char* what,
            std::optional<report::Range> percent) {
  report::Chart chart{std::move(name), "", {"speed [rad/s]"}, {"case"}};
  report::HeatMap map{std::move(label), {}, percent};
  const double width = fastest_speed / study.plan.cells;
  for (int k = 0; k < study.plan.cells; ++k) {
    chart.x.categories.push_back(fmt::format("{:.3g}", (k + 0.5) * width));
  }
  for (const CaseQuality& row : study.rows) {
    chart.y.categories.push_back(row.id);
    auto& cells = map.rows.emplace_back();
    for (const GradientQuality& quality : row.cells) {
      const Json value = data_of(quality)[what];
      cells.push_back(value.is_null() ? std::nullopt
                                      : std::optional((percent ? 100 : 1) * value.get<double>()));
    }
  }
  chart.heat_map = std::move(map);
  chart.height = 360;
  return report::data_of(chart);
}

Json step_chart(const GradientDoubtStudy& study) {
  report::Chart chart{"validity-steps",
                      "",
                      {"step, part of the range of speeds", report::Scale::logarithmic},
                      {"relative difference", report::Scale::logarithmic}};
  report::Series median{"median", report::Mark::line, {}};
  report::Series upper{"0.9 quantile", report::Mark::line, {}};
  for (auto e = study.step_errors.rbegin(); e != study.step_errors.rend(); ++e) {
    median.samples.push_back({e->step, std::max(e->median, 1e-16)});
    upper.samples.push_back({e->step, std::max(e->upper, 1e-16)});
  }
  chart.series = {median, upper};
  return report::data_of(chart);
}

}  // namespace

Json data_of(const GradientDoubtStudy& study) {
  GradientQuality all;
  for (const CaseQuality& row : study.rows) {
    for (const GradientQuality& q : row.cells) {
      all.points += q.points;
      all.agreeing += q.agreeing;
      all.trending += q.trending;
      all.right += q.right;
      for (std::size_t d = 0; d < all.doubts.size(); ++d) all.doubts[d] += q.doubts[d];
    }
  }
  Json widths = Json::array();
  for (std::size_t w = 0; w < study.plan.widths.size(); ++w) {
    widths.push_back({{"width", study.plan.widths[w]}});
    widths.back().update(data_of(study.by_width[w]));
  }
  const report::Range percent{0, 100};
  return {{"all", data_of(all)},
          {"widths", std::move(widths)},
          {"agreement", map_of(study, "validity-agreement", "agree [%]", "agreeing", percent)},
          {"trend", map_of(study, "validity-trend", "same sign [%]", "trending", percent)},
          {"flat", map_of(study, "validity-flat", "flat [%]", "flat", percent)},
          {"reach", map_of(study, "validity-reach", "log10 of the reach", "log_reach", {})},
          {"steps", step_chart(study)}};
}

}  // namespace ricochet::studies::surrogate
