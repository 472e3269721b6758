#include <algorithm>
#include <numbers>

#include "src/research/paper/crossing_motion.h"
#include "src/research/reproduction/data.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;

constexpr double degree = std::numbers::pi / 180;
constexpr double radius = 0.065;      // [m], the paper's radius of the spindle's path
constexpr double shown_speed = 9.0;   // [rad/s], the paper's threshold of case C1
constexpr double half_crossing = 45;  // [degrees]; not in the paper
constexpr double arc = 60;            // [degrees] shown on either side

/// `turned` [degrees] from where the crossing begins.
TheoreticalMotion motion_at(double turned) {
  if (turned < 0 || turned > 2 * half_crossing) return on_arc(radius, shown_speed);
  const double angle = turned <= half_crossing ? turned : turned - 2 * half_crossing;
  return on_crossing(radius, shown_speed, angle * degree);
}

}  // namespace

report::Json crossing_data() {
  report::Json motion = report::Json::array();
  TheoreticalMotion most{};
  for (double turned = -arc; turned <= 2 * half_crossing + arc; turned += 0.5) {
    const TheoreticalMotion at = motion_at(turned);
    motion.push_back({{"turned", turned}, {"speed", at.speed}, {"acceleration", at.acceleration}});
    most.speed = std::max(most.speed, at.speed);
    most.acceleration = std::max(most.acceleration, at.acceleration);
  }
  return {{"end", 2 * half_crossing},
          {"speed_gain", most.speed / on_arc(radius, shown_speed).speed},
          {"acceleration_gain", most.acceleration / on_arc(radius, shown_speed).acceleration},
          {"top_speed", 1.1 * most.speed},
          {"top_acceleration", 1.1 * most.acceleration},
          {"motion", std::move(motion)}};
}

}  // namespace ricochet::studies::reproduction
