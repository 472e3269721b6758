#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/gradients/derivatives.h"
#include "problems/carrier_track/gradients/shape_derivatives.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "src/core/progress.h"
#include "src/studies/surrogate/study.h"

namespace ricochet::studies::surrogate {

namespace {

using namespace carrier_track;

constexpr double trend_reach = 0.5;  // [rad/s] to either side
constexpr int trend_points = 10;     // to either side

/// The slope of the count by least squares [per rad/s].
double trend_of(const Scene& scene, double omega) {
  double products = 0;
  double squares = 0;
  for (int k = -trend_points; k <= trend_points; ++k) {
    const double shift = trend_reach * k / trend_points;
    const double speed = std::clamp(omega + shift, slowest_speed, fastest_speed);
    products += shift * objective(at_speed(scene, speed), 0.0);
    squares += shift * shift;
  }
  return products / squares;
}

/// Share of right signs by case and speed; a cell without a trend has no value.
report::Chart trend_chart(const Table& gradients, const Row& all) {
  report::Chart chart{
      .name = "validity-trend",
      .title = fmt::format("The gradient has the sign of the count's trend at {:.0f} % of all "
                           "points; {:.0f} % have no trend or a flat gradient",
                           100 * all.number("right"), 100 * all.number("no_trend")),
      .x = {"speed [rad/s]"},
      .y = {"case"},
      .heat_map = report::HeatMap{"same sign [%]", {}, report::Range{0, 100}},
      .height = 360};
  const Table cells =
      aggregated(where(gradients, [](const Row& row) { return !row.is("neither"); }),
                 {"case", "speed"}, {{{"right"}, "right", mean_of}});
  const auto names = [&](const char* column) { return aggregated(gradients, {column}, {}); };
  const Table speeds = names("speed"), cases = names("case");
  each_row(speeds, [&](const Row& row) {
    chart.x.categories.push_back(fmt::format("{:.3g}", row.number("speed")));
  });
  each_row(cases, [&](const Row& row) { chart.y.categories.push_back(row.text("case")); });
  for (const auto& a_case : cases.rows) {
    auto& line = chart.heat_map->rows.emplace_back();
    for (const auto& speed : speeds.rows) {
      const auto cell = cells.find(
          [&](const Row& row) { return row["case"] == a_case[0] && row["speed"] == speed[0]; });
      line.push_back(cell ? std::optional(100 * cell->number("right")) : std::nullopt);
    }
  }
  return chart;
}

}  // namespace

Table gradients(const std::vector<double>& smoothings, int cells, int points) {
  Table table{"gradients",
              columns_named("smoothing,case,speed,flat,kink,sensitive,right,wrong,neither")};
  const std::vector<Machine> machines = all_machines();
  const int each = cells * points;
  Progress progress("gradients", static_cast<double>(machines.size()));
  for (const Machine& machine : machines) {
    const std::size_t first = table.rows.size();
    table.rows.resize(first + static_cast<std::size_t>(each) * smoothings.size());
    tbb::parallel_for(0, each, [&](int k) {
      const double omega = std::max(fastest_speed * (k + 0.5) / each, 0.2);
      const double trend = trend_of(machine.scene, omega);
      const int cell = k / points;
      const double middle = (cell + 0.5) * fastest_speed / cells;
      for (std::size_t s = 0; s < smoothings.size(); ++s) {
        const Slope found = surrogate_slope(at_speed(machine.scene, omega), smoothings[s],
                                            fastest_speed - slowest_speed);
        const GradientDoubt doubt = found.trust.doubt;
        const bool neither = trend == 0 || doubt == GradientDoubt::flat;
        const bool same = (trend > 0) == (found.slope > 0);
        table.rows[first + static_cast<std::size_t>(k) * smoothings.size() + s] = {
            smoothings[s],
            machine.id,
            middle,
            doubt == GradientDoubt::flat,
            doubt == GradientDoubt::kink,
            doubt == GradientDoubt::sensitive,
            !neither && same,
            !neither && !same,
            neither};
      }
    });
    progress.advance(1);
  }
  return table;
}

void add_gradients(report::Results& results, const Table& gradients) {
  Table table = aggregated(gradients, {"smoothing"},
                           {{{"points"}, "", count_of},
                            {{"right", "sign of the count's trend [%]", ".1%"}, "right", mean_of},
                            {{"wrong", "other sign [%]", ".1%"}, "wrong", mean_of},
                            {{"no_trend", "nothing to compare [%]", ".1%"}, "neither", mean_of},
                            {{"flat", "flat [%]", ".1%"}, "flat", mean_of},
                            {{"kink", "next to a kink [%]", ".1%"}, "kink", mean_of},
                            {{"sensitive", "sensitive [%]", ".1%"}, "sensitive", mean_of}});
  table.name = "validity";
  table.columns.front() = {"smoothing", "smoothing parameter", "g"};
  const Table usual = where(table, "smoothing", default_smoothing);
  const Row row = usual[0];
  results.set("gradients", row["points"]);
  results.set("gradients-right", row["right"]);
  results.set("gradients-wrong", row["wrong"]);
  results.set("gradients-without-trend", row["no_trend"]);
  results.set("usual-smoothing", default_smoothing);
  results.set("short-reach", short_reach);
  results.add(trend_chart(where(gradients, "smoothing", default_smoothing), row));
  results.add(std::move(table));
}

}  // namespace ricochet::studies::surrogate
