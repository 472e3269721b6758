#include "src/research/paper/crossing_motion.h"

#include <cmath>
#include <numbers>

namespace ricochet::carrier_track::inline paper {

TheoreticalMotion on_arc(double radius, double omega) {
  return {radius * omega, radius * omega * omega};
}

TheoreticalMotion on_crossing(double radius, double omega, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {radius * omega / (c * c),
          radius * omega * omega / (c * c * c) * std::sqrt(c * c * c * c + 4 * s * s * s * s)};
}

CrossingParts crossing_parts(double radius, double omega, double angle) {
  const double c = std::cos(angle);
  const double push = radius * omega * omega;
  return {push / c, 2 * push * std::sin(angle) / (c * c * c)};
}

std::vector<SpeedKnot<double>> crossing_profile(double omega, double angle, double turns) {
  std::vector<SpeedKnot<double>> knots;
  for (int half = 0; half < std::ceil(2 * turns); ++half) {
    const double middle = std::numbers::pi * (half + 0.5);
    // The leading plate has turned by `driven` from the tangent, or has as far to go.
    for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
      const double driven = angle * (1 - std::abs(share));
      knots.push_back({(middle + share * angle) / omega, on_crossing(1.0, omega, driven).speed});
    }
  }
  return knots;
}

}  // namespace ricochet::carrier_track::inline paper
