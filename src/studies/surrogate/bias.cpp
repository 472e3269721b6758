#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/suite/machine.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "src/core/progress.h"
#include "src/studies/surrogate/study.h"

namespace ricochet::studies::surrogate {

namespace {

using namespace carrier_track;

std::vector<double> over_speeds(const Machine& machine, double smoothing, double step) {
  std::vector<double> values(static_cast<std::size_t>(std::lround(fastest_speed / step)));
  tbb::parallel_for(std::size_t{0}, values.size(), [&](std::size_t k) {
    values[k] = objective(at_speed(machine.scene, static_cast<double>(k + 1) * step), smoothing);
  });
  return values;
}

/// The last place at which the values are at most `level`.
std::optional<std::size_t> last_quiet(const std::vector<double>& values, double level) {
  for (std::size_t k = values.size(); k-- > 0;) {
    if (values[k] <= level) return k;
  }
  return std::nullopt;
}

/// How far the surrogate's top speeds are off at one smoothing parameter.
struct SpeedError {
  double median, worst;  ///< [rad/s]; of a surrogate that is never quiet, the whole range
  std::size_t loud;      ///< cases
};

SpeedError speed_error(const Table& bias, double smoothing) {
  std::vector<Value> sizes;
  std::size_t loud = 0;
  each_row(where(bias, "smoothing", smoothing), [&](const Row& row) {
    sizes.emplace_back(std::abs(row.number_if("speed_optimality_gap").value_or(fastest_speed)));
    loud += row.number_if("quiet") == 0.0;
  });
  return {*number_in(median_of(sizes)), *number_in(most_of(sizes)), loud};
}

report::Chart speed_gap_chart(const Table& bias) {
  const SpeedError error = speed_error(bias, default_smoothing);
  report::Chart chart{
      .name = "speed-gap",
      .title = fmt::format("At smoothing parameter {:g} the top speed in the window is {:.2f} "
                           "rad/s off at worst, {:.2f} in the median",
                           default_smoothing, error.worst, error.median),
      .x = {"smoothing parameter", report::Scale::logarithmic},
      .y = {"off by [rad/s]"},
      .width = 760,
      .height = 340};
  each_row(sorted(bias, {"smoothing"}), [&](const Row& row) {
    auto& all = chart.series;
    auto series = std::ranges::find(all, row.text("case"), &report::Series::label);
    if (series == all.end()) series = all.insert(all.end(), {row.text("case")});
    std::optional<double> gap = row.number_if("speed_optimality_gap");
    if (gap) gap = std::abs(*gap);
    series->samples.push_back({row.number("smoothing"), gap});
  });
  return chart;
}

/// A row for each case, a column for each smoothing parameter.
Table quiet_speeds(const Table& bias) {
  Table speeds{"quiet-speeds", {{"case"}, {"fastest", "truly", ".2f"}}};
  each_row(bias, [&](const Row& row) {
    if (speeds.rows.empty() || speeds[speeds.rows.size() - 1]["case"] != row["case"])
      speeds.rows.push_back({row["case"], row["fastest"]});
    speeds.rows.back().push_back(row["speed"]);
    if (speeds.rows.size() > 1) return;
    const double smoothing = row.number("smoothing");
    speeds.columns.push_back(
        {fmt::format("at_{:g}", smoothing), fmt::format("at {:g}", smoothing), ".2f"});
  });
  return speeds;
}

}  // namespace

Table bias(double step, const std::vector<double>& smoothings) {
  Table table{"bias",
              {{"case"},
               {"fastest", "truly quiet up to [rad/s]", ".2f"},
               {"smoothing", "smoothing parameter", "g"},
               {"speed", "fastest speed it calls quiet [rad/s]", ".2f"},
               {"speed_optimality_gap", "short of the true one by [rad/s]", "+.2f"},
               {"quiet", "truly quiet there"},
               {"count_optimality_gap", "count at its minimum, above the lowest", ".0f"}}};
  const std::vector<Machine> machines = all_machines();
  Progress progress("surrogate bias", static_cast<double>(machines.size()));
  const auto speed = [&](std::size_t k) { return static_cast<double>(k + 1) * step; };
  for (const Machine& machine : machines) {
    const std::vector<double> counts = over_speeds(machine, 0, step);
    const double lowest = *std::ranges::min_element(counts);
    const auto best = last_quiet(counts, machine.quiet_limit);
    for (const double smoothing : smoothings) {
      const std::vector<double> values = over_speeds(machine, smoothing, step);
      const auto quiet = last_quiet(values, half_level(machine.quiet_limit));
      const auto minimum = std::ranges::min_element(values) - values.begin();
      table.add(machine.id, value_of(best, speed), smoothing, value_of(quiet, speed),
                best && quiet ? std::optional(speed(*best) - speed(*quiet)) : std::nullopt,
                value_of(quiet, [&](std::size_t k) { return counts[k] <= machine.quiet_limit; }),
                counts[static_cast<std::size_t>(minimum)] - lowest);
    }
    progress.advance(1);
  }
  return table;
}

void add_bias(report::Results& results, const Table& bias, double step) {
  std::size_t fast = 0, slow = 0, higher = 0;
  double narrowest = default_smoothing;
  each_row(bias, [&](const Row& row) {
    const double gap = row.number_if("speed_optimality_gap").value_or(fastest_speed);
    fast += gap < -0.5 * step;
    slow += gap > 0.5 * step;
    higher += row.number("count_optimality_gap") > 0;
    narrowest = std::min(narrowest, row.number("smoothing"));
  });
  Table speeds = quiet_speeds(bias);
  const SpeedError wide = speed_error(bias, default_smoothing),
                   narrow = speed_error(bias, narrowest);
  results.set(
      "finding",
      fmt::format("At smoothing parameter {:g} the fastest speed that the surrogate calls quiet is "
                  "off by {:.2f} rad/s in the median of {} cases, by {:.2f} at worst, and truly "
                  "loud in {}; at {:g} it is off by {:.2f} and {:.2f} rad/s, but still truly loud "
                  "in {}.",
                  default_smoothing, wide.median, speeds.rows.size(), wide.worst, wide.loud,
                  narrowest, narrow.median, narrow.worst, narrow.loud));
  results.set("pairs", bias.rows.size());
  results.set("too-fast", fast);
  results.set("too-slow", slow);
  results.set("bias-step", step);
  results.set("higher-minima", higher);
  results.set("speeds", std::lround(fastest_speed / step));
  results.add(bias);
  results.add(std::move(speeds));
  results.add(speed_gap_chart(bias));
}

}  // namespace ricochet::studies::surrogate
