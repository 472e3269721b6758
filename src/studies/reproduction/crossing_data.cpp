#include <cmath>
#include <numbers>

#include "problems/carrier_track/paper/crossing_motion.h"
#include "src/report/chart_data.h"
#include "src/studies/reproduction/data.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;

constexpr double degree = std::numbers::pi / 180;
constexpr double radius = 0.065;      // [m], the paper's radius of the spindle's path
constexpr double omega = 9.0;         // [rad/s], the paper's threshold of case C1
constexpr double half_crossing = 45;  // [degrees]; not in the paper
constexpr double arc = 60;            // [degrees] shown on either side

/// `turned` [degrees] from where the crossing begins.
TheoreticalMotion motion_at(double turned) {
  if (turned < 0 || turned > 2 * half_crossing) return on_arc(radius, omega);
  const double angle = turned <= half_crossing ? turned : turned - 2 * half_crossing;
  return on_crossing(radius, omega, angle * degree);
}

report::Json chart_of(const char* name, const char* label, double TheoreticalMotion::*part) {
  report::Chart chart;
  chart.name = name;
  chart.x.label = "driver plates [degrees turned since the crossing began]";
  chart.y.label = label;
  report::Series series{"", report::Mark::line, {}};
  double most = 0;
  for (double turned = -arc; turned <= 2 * half_crossing + arc; turned += 0.5) {
    const double value = motion_at(turned).*part;
    series.samples.push_back({turned, value});
    most = std::max(most, value);
  }
  chart.y.range = report::Range{0, 1.1 * most};
  chart.series = {std::move(series)};
  chart.lines = {{report::Direction::vertical, 0, "crossing"},
                 {report::Direction::vertical, 2 * half_crossing, "crossing"}};
  return report::data_of(chart);
}

}  // namespace

report::Json crossing_data() {
  return {{"speed", chart_of("crossing-speed", "speed [m/s]", &TheoreticalMotion::speed)},
          {"acceleration", chart_of("crossing-acceleration", "acceleration [m/s²]",
                                    &TheoreticalMotion::acceleration)}};
}

}  // namespace ricochet::studies::reproduction
