#include "problems/carrier_track/transition.h"

#include <cmath>

namespace ricochet::carrier_track {

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

}  // namespace ricochet::carrier_track
