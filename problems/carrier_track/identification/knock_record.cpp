#include "problems/carrier_track/identification/knock_record.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ricochet::carrier_track::inline identification {
namespace {

constexpr double turn = 2 * std::numbers::pi;

}  // namespace

double speed_at(const std::vector<SpeedKnot<double>>& speed, double time) {
  const auto after = std::ranges::lower_bound(speed, time, {}, &SpeedKnot<double>::time);
  if (after == speed.begin()) return speed.front().omega;
  if (after == speed.end()) return speed.back().omega;
  const SpeedKnot<double>& before = *std::prev(after);
  const double share = (time - before.time) / (after->time - before.time);
  return before.omega + share * (after->omega - before.omega);
}

double angle_between(const std::vector<SpeedKnot<double>>& speed, double from, double to) {
  double angle = 0;
  double time = from;
  double omega = speed_at(speed, from);
  const auto go_to = [&](double end) {
    const double then = speed_at(speed, end);
    angle += (end - time) * (omega + then) / 2;
    time = end;
    omega = then;
  };
  auto knot = std::ranges::upper_bound(speed, from, {}, &SpeedKnot<double>::time);
  for (; knot != speed.end() && knot->time < to; ++knot) go_to(knot->time);
  go_to(to);
  return angle;
}

PlateMeasurement plate_measurement(const KnockRecord& record, const std::vector<double>& marks,
                                   double mark_angle) {
  const auto n = static_cast<Eigen::Index>(marks.size());
  Matrix design(n, 2);
  Vector alpha(n);
  const double first = marks.front();
  double turned = first >= record.from ? angle_between(record.speed, record.from, first)
                                       : -angle_between(record.speed, first, record.from);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double time = marks[static_cast<std::size_t>(i)];
    const double since_last =
        i == 0 ? 0 : angle_between(record.speed, marks[static_cast<std::size_t>(i - 1)], time);
    const double turns = std::max(i == 0 ? 0.0 : 1.0, std::round(since_last / turn));
    turned += since_last;
    design.row(i) << 1, turned;
    alpha[i] = (i == 0 ? mark_angle : alpha[i - 1]) + turn * turns;
  }
  const Vector line = design.colPivHouseholderQr().solve(alpha);
  const double squares = (alpha - design * line).squaredNorm();
  const double variance = std::max(squares / static_cast<double>(n - 2), 1e-12);
  // The second unknown is a logarithm: its slope is the factor itself.
  design.col(1) *= line[1];
  return {line[0], std::log(line[1]), design.transpose() * design / variance, std::sqrt(variance)};
}

}  // namespace ricochet::carrier_track::inline identification
