#include <cmath>
#include <numbers>

#include "problems/carrier_track/paper/crossing_motion.h"
#include "src/studies/reproduction/sections.h"

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

report::Figure chart_of(const char* name, const char* title, const char* label,
                        double TheoreticalMotion::*part) {
  report::Chart chart;
  chart.name = name;
  chart.title = title;
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
  return {chart, ""};
}

}  // namespace

report::Section crossing_section() {
  report::Section section{"crossing", "Speed and acceleration along the track (Figure 3)"};
  section.paragraphs = {
      "Equations (1)-(5) at 9 rad/s and radius 65 mm: even motion on the arcs, and a straight "
      "crossing from one driver plate to the next, where speed and acceleration peak half way. How "
      "far a plate turns on its half of the crossing is not in the paper; 45 degrees are drawn. "
      "Equation (5) follows from (4) only if normal and tangential part enclose 90 degrees more "
      "than the angle printed, so (4) is read that way."};
  section.figures = {
      chart_of("crossing-speed", "Speed of the carrier", "speed [m/s]", &TheoreticalMotion::speed),
      chart_of("crossing-acceleration", "Acceleration of the carrier", "acceleration [m/s²]",
               &TheoreticalMotion::acceleration)};
  return section;
}

}  // namespace ricochet::studies::reproduction
