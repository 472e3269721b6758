#include "src/report/simplified.h"

#include <boost/geometry/algorithms/simplify.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/strategies/strategies.hpp>

namespace ricochet::report {

std::vector<Sample> simplified(const std::vector<Sample>& samples, double across, double up) {
  using Point = boost::geometry::model::d2::point_xy<double>;
  using Line = boost::geometry::model::linestring<Point>;
  const auto place = [&](const Sample& sample) {
    return Point(sample.position / across, *sample.value / up);
  };
  Line line;
  Line kept;
  for (const Sample& sample : samples) line.push_back(place(sample));
  boost::geometry::simplify(line, kept, 1.0);
  // Those kept are some of the points, in their order.
  std::vector<Sample> corners;
  auto next = kept.begin();
  for (const Sample& sample : samples) {
    if (next == kept.end()) break;
    const Point point = place(sample);
    if (point.x() != next->x() || point.y() != next->y()) continue;
    corners.push_back(sample);
    ++next;
  }
  return corners;
}

}  // namespace ricochet::report
