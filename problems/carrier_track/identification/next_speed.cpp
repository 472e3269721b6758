#include "problems/carrier_track/identification/next_speed.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace ricochet::carrier_track::inline identification {
namespace {

constexpr int speeds = 40;

/// The largest derivative of an impact's time by a constant of the machine.
double steepest(const std::vector<PredictedImpact>& impacts, double from, double to) {
  double most = 0;
  for (const PredictedImpact& impact : impacts) {
    if (impact.time < from || impact.time > to) continue;
    for (std::size_t i = 0; i < machine_constants; ++i) {
      most = std::max(most, std::abs(impact.time_slopes[i]));
    }
  }
  return most;
}

/// Returns true if small changes grow from turn to turn.
bool is_sensitive(const KnockDensity& density, const KnockRecord& record) {
  const double middle = (record.from + record.to) / 2;
  return steepest(density.impacts(), middle, record.to) >
         5 * steepest(density.impacts(), record.from, middle);
}

}  // namespace

Matrix covariance_of(const KnockDensity::Information& information,
                     const std::vector<Eigen::Index>& free) {
  const auto n = static_cast<Eigen::Index>(free.size());
  const Matrix inverse =
      Matrix(information.information(free, free)).ldlt().solve(Matrix::Identity(n, n));
  Matrix covariance = Matrix::Zero(knock_unknowns, knock_unknowns);
  covariance(free, free) = inverse * Matrix(information.score(free, free)) * inverse;
  return covariance;
}

std::optional<NextSpeed> next_speed(const KnockLoss& loss, const Vector& x, const Vector& target,
                                    double fastest) {
  const KnockRecord& record = loss.record();
  const auto [slow, fast] = std::ranges::minmax(record.speed, {}, &SpeedKnot<double>::omega);
  const double lowest = std::max(slow.omega, fast.omega / 20) / 3;
  const double highest = std::min(fastest, 2 * fast.omega);
  const KnockDensity::Information now = loss.information(x);
  const auto deviation = [&](const KnockDensity::Information& information) {
    const Matrix covariance = covariance_of(information, loss.free());
    return std::sqrt(target.dot(covariance.topLeftCorner(target.size(), target.size()) * target));
  };
  const double before = deviation(now);
  const double turned =
      angle_between(record.speed, record.from, record.to) * unknowns_at(x).speed_factor;
  std::optional<NextSpeed> best;
  for (int k = 0; k < speeds; ++k) {
    const double omega = lowest * std::pow(highest / lowest, k / (speeds - 1.0));
    KnockRecord step{{}, {{0, omega}}, 0, next_step_seconds};
    step.knocks = record.knocks;  // they say whether there are strengths, and of which range
    step.saturation = record.saturation;
    Vector there = x;
    there[coordinate::phase] += turned;
    const KnockDensity density(
        step, predicted_impacts(loss.scene(), step, there, loss.slowest(there)), there, 0);
    if (density.impacts().empty() || is_sensitive(density, step)) continue;
    // The angle at which the step begins depends on the speeds before.
    Matrix by = Matrix::Identity(knock_unknowns, knock_unknowns);
    by(coordinate::phase, coordinate::speed_factor) = turned;
    KnockDensity::Information both = density.information();
    both.information = now.information + by.transpose() * both.information * by;
    both.score = now.score + by.transpose() * both.score * by;
    const double after = deviation(both);
    if (!best || after < best->deviation) best = NextSpeed{omega, after, before};
  }
  return best;
}

}  // namespace ricochet::carrier_track::inline identification
