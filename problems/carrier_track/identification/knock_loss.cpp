#include "problems/carrier_track/identification/knock_loss.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet::carrier_track::inline identification {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Impacts this many deviations below the detection limit are not predicted.
constexpr double undetectable = 5;

/// Of the clocks of two recorders without a common clock.
constexpr double drift_deviation = 1e-4;

}  // namespace

KnockLoss::KnockLoss(const Scene& scene, const KnockRecord& record)
    : scene_(scene), record_(record), guess_(), deviations_(knock_unknowns) {
  KnockUnknowns guess = guess_of(scene);
  for (Eigen::Index i = 0; i <= coordinate::spurious_rate; ++i) free_.push_back(i);
  free_.push_back(coordinate::upper_share);
  if (record.lag_deviation > 0) {
    free_.insert(free_.end(), {coordinate::lag, coordinate::drift});
  }
  if (record.has_strengths()) {
    const auto weakest = std::ranges::min(record.knocks, {}, &Knock::strength);
    guess.detection_limit = *weakest.strength;
    guess.gain = guess.detection_limit / scene.counting_limit;
    free_.insert(free_.end(), {coordinate::gain, coordinate::scatter});
  } else {
    free_.push_back(coordinate::detection_limit);
  }
  guess.spurious_rate =
      std::max(0.1 * static_cast<double>(record.knocks.size()), 1.0) / record.duration();
  if (record.plate) {
    guess.phase = record.plate->phase;
    guess.speed_factor = std::exp(record.plate->log_speed);
  }
  guess_ = point_of(guess);
  deviations_ << 2, 1.5, 1.5, unlimited, record.plate ? unlimited : 0.02, 3, unlimited, unlimited,
      1.5, 5, 2, unlimited, record.lag_deviation > 0 ? record.lag_deviation : unlimited,
      record.lag_deviation > 0 ? drift_deviation : unlimited;
}

double KnockLoss::slowest(const Vector& x) const {
  const KnockUnknowns at = unknowns_at(x);
  return at.detection_limit / at.gain * std::exp(-undetectable * at.scatter);
}

KnockDensity KnockLoss::density(const Vector& x, double blur) const {
  return {record_, predicted_impacts(scene_, record_, x, slowest(x)), x, blur};
}

double KnockLoss::at(const Vector& x, double blur, Vector* slopes) const {
  if (slopes != nullptr) *slopes = Vector::Zero(knock_unknowns);
  const KnockDensity density{record_,
                             slopes != nullptr ? predicted_impacts(scene_, record_, x, slowest(x))
                                               : plain_impacts(scene_, record_, x, slowest(x)),
                             x, blur};
  double loss = density.expected(slopes) + prior(x, slopes);
  for (const Knock& knock : record_.knocks) loss -= density.log_at(knock, slopes, -1);
  return loss;
}

double KnockLoss::prior(const Vector& x, Vector* slopes) const {
  double sum = 0;
  for (Eigen::Index i = 0; i < knock_unknowns; ++i) {
    const double z = (x[i] - guess_[i]) / deviations_[i];
    sum += z * z / 2;
    if (slopes != nullptr) (*slopes)[i] += z / deviations_[i];
  }
  if (record_.plate) {
    const Vector off = x.segment(coordinate::phase, 2) - guess_.segment(coordinate::phase, 2);
    const Vector pull = record_.plate->information * off;
    sum += off.dot(pull) / 2;
    if (slopes != nullptr) slopes->segment(coordinate::phase, 2) += pull;
  }
  // Half a knock that is missed, half a spurious one: without any the logarithms have no end.
  const KnockUnknowns at = unknowns_at(x);
  sum -= (std::log(at.recorded_share * (1 - at.recorded_share)) +
          std::log(at.upper_share * (1 - at.upper_share)) + std::log(at.spurious_rate)) /
         2;
  if (slopes != nullptr) {
    (*slopes)[coordinate::recorded_share] -= (1 - 2 * at.recorded_share) / 2;
    (*slopes)[coordinate::upper_share] -= (1 - 2 * at.upper_share) / 2;
    (*slopes)[coordinate::spurious_rate] -= 0.5;
  }
  return sum;
}

KnockDensity::Information KnockLoss::information(const Vector& x, double blur) const {
  KnockDensity::Information result = density(x, blur).information();
  const KnockUnknowns at = unknowns_at(x);
  for (Matrix* matrix : {&result.information, &result.score}) {
    for (Eigen::Index i = 0; i < knock_unknowns; ++i) {
      (*matrix)(i, i) += 1 / (deviations_[i] * deviations_[i]);
    }
    if (record_.plate)
      matrix->block(coordinate::phase, coordinate::phase, 2, 2) += record_.plate->information;
    (*matrix)(coordinate::recorded_share, coordinate::recorded_share) +=
        at.recorded_share * (1 - at.recorded_share);
    (*matrix)(coordinate::upper_share, coordinate::upper_share) +=
        at.upper_share * (1 - at.upper_share);
    (*matrix)(coordinate::spurious_rate, coordinate::spurious_rate) += 0.5;
  }
  return result;
}

}  // namespace ricochet::carrier_track::inline identification
