#include "src/identification/fit_start.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "src/core/time_limit.h"

namespace ricochet::studies::identification {

using namespace carrier_track;

namespace {

constexpr int draws = 40;
constexpr int angles = 90;
constexpr double angle_width = 0.07;  // [rad], of a predicted knock
constexpr double background = 0.05;   // density of spurious knocks over that of an impact's peak

/// What the driver plate has turned [rad] since the record's start, by recorded speeds.
class PlateAngle {
 public:
  explicit PlateAngle(const KnockRecord& record) : record_(record) {}

  /// Times must rise from call to call.
  double at(double time) {
    angle_ += angle_between(record_.speed, time_, time);
    time_ = time;
    return angle_;
  }

 private:
  const KnockRecord& record_;
  double time_ = record_.from;
  double angle_ = 0;
};

std::vector<double> plate_angles(const KnockRecord& record) {
  PlateAngle plate(record);
  std::vector<double> result;
  for (const Knock& knock : record.knocks) result.push_back(plate.at(knock.time));
  return result;
}

/// The factor of all speeds at which the knocks recur best at the same two angles of the plate:
/// impacts come once on either wall in a turn.
double best_speed_factor(const std::vector<double>& knocks) {
  const double turned = std::max(1.0, knocks.back() - knocks.front());
  constexpr double widest = 0.03;
  const double step = 0.25 / turned;
  double best = 1;
  double most = 0;
  for (double offset = 0; offset <= widest; offset += step) {
    check_time_limit();
    report_progress("speed of the record", offset / widest);
    for (const double factor : {1 - offset, 1 + offset}) {
      std::complex<double> sum = 0;
      for (const double angle : knocks) sum += std::polar(1.0, 2 * factor * angle);
      // What fits equally well is taken for nearer to 1.
      if (std::abs(sum) <= 1.02 * most) continue;
      most = std::abs(sum);
      best = factor;
    }
  }
  return best;
}

struct Guess {
  double score;
  Vector x;
};

/// How well impacts at these angles of the plate, moved back by `phase`, explain the knocks.
double score_of(const std::vector<double>& knocks, const std::vector<double>& impacts,
                double phase) {
  double sum = 0;
  auto first = impacts.begin();
  for (const double knock : knocks) {
    double density = background;
    while (first != impacts.end() && *first - phase < knock - 4 * angle_width) ++first;
    for (auto impact = first; impact != impacts.end(); ++impact) {
      const double z = (*impact - phase - knock) / angle_width;
      if (z > 4) break;
      density += std::exp(-z * z / 2);
    }
    sum += std::log(density);
  }
  // Impacts that no knock shows cost as much as the density says.
  return sum - static_cast<double>(impacts.size());
}

Vector drawn(const Vector& guess, bool as_given, Random& random) {
  Vector x = guess;
  if (as_given) return x;
  const Vector u = uniform_point(Vector::Constant(3, -1), Vector::Constant(3, 1), random);
  x[coordinate::restitution] += 1.5 * u[0];
  x[coordinate::friction] += 0.7 * u[1];
  x[coordinate::clearance] += 0.9 * u[2];
  return x;
}

}  // namespace

std::vector<Vector> fit_starts(const KnockLoss& loss, std::size_t most, Random& random) {
  const KnockRecord& record = loss.record();
  const std::vector<double> knocks = plate_angles(record);
  const double factor =
      record.plate ? std::exp(loss.guess()[coordinate::speed_factor]) : best_speed_factor(knocks);
  std::vector<double> turned;
  for (const double angle : knocks) turned.push_back(factor * angle);
  const double slowest = loss.scene().counting_limit;
  std::vector<Guess> guesses;
  for (int k = 0; k < draws; ++k) {
    report_progress("starts of the fit", k / static_cast<double>(draws));
    Vector x = drawn(loss.guess(), k == 0, random);
    x[coordinate::speed_factor] = std::log(factor);
    PlateAngle plate(record);
    std::vector<double> impacts;
    for (const PredictedImpact& impact : plain_impacts(loss.scene(), record, x, slowest)) {
      impacts.push_back(factor * plate.at(impact.time));
    }
    Guess best{-std::numeric_limits<double>::infinity(), x};
    for (int i = 0; i < (record.plate ? 1 : angles); ++i) {
      check_time_limit();
      const double phase = 2 * std::numbers::pi * i / angles;
      const double score = score_of(turned, impacts, phase);
      if (score <= best.score) continue;
      best.score = score;
      best.x[coordinate::phase] = loss.guess()[coordinate::phase] + phase;
    }
    guesses.push_back(best);
  }
  std::ranges::stable_sort(guesses, std::greater(), &Guess::score);
  std::vector<Vector> starts;
  for (std::size_t k = 0; k < std::min(most, guesses.size()); ++k) starts.push_back(guesses[k].x);
  return starts;
}

}  // namespace ricochet::studies::identification
