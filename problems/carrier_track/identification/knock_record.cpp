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
                                   double mark_angle, double angle_deviation) {
  const auto n = static_cast<Eigen::Index>(marks.size());
  Matrix design(n, 3);
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
    design.row(i) << 1, turned, -speed_at(record.speed, time);
    alpha[i] = (i == 0 ? mark_angle : alpha[i - 1]) + turn * turns;
  }
  Vector line = Vector::Zero(3);
  line.head(2) = design.leftCols(2).colPivHouseholderQr().solve(alpha);
  const auto variance = [&] {
    const double squares = (alpha - design * line).squaredNorm();
    return std::max(squares / static_cast<double>(n - 2), 1e-12);
  };
  double of_mark = variance();
  if (record.lag_deviation > 0) {
    // The lag is one more measurement of the line: 0, in units of a mark's deviation.
    constexpr int rounds = 5;  // the variance is that about the line with the lag
    for (int round = 0; round < rounds; ++round) {
      Matrix rows(n + 1, 3);
      rows << design, 0, 0, std::sqrt(of_mark) / record.lag_deviation;
      Vector right(n + 1);
      right << alpha, 0;
      line = rows.colPivHouseholderQr().solve(right);
      of_mark = variance();
    }
  }
  // The second unknown is a logarithm: its slope is the factor itself.
  design.col(1) *= line[1];
  Matrix information = design.leftCols(2).transpose() * design.leftCols(2) / of_mark;
  if (record.lag_deviation > 0) {
    const Vector with_lag = design.leftCols(2).transpose() * design.col(2) / of_mark;
    const double of_lag =
        design.col(2).squaredNorm() / of_mark + 1 / (record.lag_deviation * record.lag_deviation);
    information -= with_lag * with_lag.transpose() / of_lag;
  }
  // An unknown angle of the mark: (information^-1 + variance of the phase)^-1.
  const Vector of_phase = information.col(0);
  const double spread = angle_deviation * angle_deviation;
  information -= of_phase * of_phase.transpose() * (spread / (1 + spread * of_phase[0]));
  return {line[0], std::log(line[1]), information, std::sqrt(of_mark)};
}

}  // namespace ricochet::carrier_track::inline identification
