#include "problems/carrier_track/identification/knock_loss.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "src/core/time_limit.h"

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

namespace {

constexpr double scatter_without_strengths = 0.1;
constexpr double longest_blur = 0.1;  // [s]
constexpr double reach = 7;           // in widths: where a Gaussian ends

double gaussian(double z) {
  return std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi);
}

double share_below(double z) {
  return std::erfc(-z / std::numbers::sqrt2) / 2;
}

/// The range of the logarithms of the strengths.
double range_of(const KnockRecord& record, bool strengths) {
  if (!strengths) return 1;
  const auto [least, most] =
      std::ranges::minmax(record.knocks, {}, [](const Knock& knock) { return *knock.strength; });
  return std::max(0.1, std::log(*most.strength / *least.strength));
}

Eigen::Index share_of(Wall wall) {
  return wall == Wall::lower ? coordinate::recorded_share : coordinate::upper_share;
}

}  // namespace

KnockDensity::KnockDensity(const KnockRecord& record, std::vector<PredictedImpact> impacts,
                           const Vector& x, double blur)
    : record_(record),
      impacts_(std::move(impacts)),
      at_(unknowns_at(x)),
      blur_(blur),
      strengths_(record.has_strengths() && blur == 0) {
  strength_range_ = range_of(record, strengths_);
  if (!strengths_) at_.scatter = scatter_without_strengths;
}

/// The width [s] of the Gaussians around a knock: as long as the plate turns by the blur.
double KnockDensity::width(double time) const {
  if (blur_ == 0) return at_.jitter;
  return std::hypot(at_.jitter, std::min(blur_ / speed_at(record_.speed, time), longest_blur));
}

/// How far an impact's strength is above the detection limit, in deviations of strengths.
double KnockDensity::margin(const PredictedImpact& impact) const {
  return (std::log(at_.gain / at_.detection_limit) + impact.log_speed) / at_.scatter;
}

double KnockDensity::wall_share(const PredictedImpact& impact) const {
  return impact.wall == Wall::lower ? at_.recorded_share : at_.upper_share;
}

double KnockDensity::recorded_share(const PredictedImpact& impact) const {
  return wall_share(impact) * share_below(margin(impact));
}

void KnockDensity::add(Vector* slopes, const PredictedImpact& impact, double by_time,
                       double by_log_speed) const {
  for (Eigen::Index i = 0; i < motion_unknowns; ++i) {
    const auto k = static_cast<std::size_t>(i);
    (*slopes)[i] += by_time * impact.time_slopes[k] + by_log_speed * impact.log_speed_slopes[k];
  }
  (*slopes)[coordinate::lag] += by_time;
  (*slopes)[coordinate::drift] +=
      by_time * (impact.time - record_.from - at_.lag) / (1 + at_.drift);
}

std::vector<KnockDensity::Explained> KnockDensity::explained(bool slopes) const {
  if (record_.dead_time <= at_.jitter || blur_ > 0) return {};
  std::vector<Explained> result;
  for (const Knock& knock : record_.knocks) {
    Explained& knock_explained = result.emplace_back();
    if (slopes) knock_explained.slopes = Vector::Zero(knock_unknowns);
    knock_explained.density = std::exp(log_at(knock, slopes ? &knock_explained.slopes : nullptr));
  }
  return result;
}

KnockDensity::Heard KnockDensity::heard(const PredictedImpact& impact,
                                        const std::vector<Explained>& explained) const {
  const double begin = (impact.time - record_.from) / at_.jitter;
  const double end = (impact.time - record_.to) / at_.jitter;
  Heard result{share_below(begin) - share_below(end),
               (gaussian(begin) - gaussian(end)) / at_.jitter,
               end * gaussian(end) - begin * gaussian(begin),
               {}};
  if (explained.empty()) return result;
  const bool slopes = explained.front().slopes.size() > 0;
  if (slopes) result.by_owner = Vector::Zero(knock_unknowns);
  const double earliest = impact.time - reach * at_.jitter - record_.dead_time;
  auto knock = std::ranges::lower_bound(record_.knocks, earliest, {}, &Knock::time);
  for (; knock != record_.knocks.end(); ++knock) {
    const double from = (knock->time - impact.time) / at_.jitter;
    if (from > reach) break;
    const double to = (knock->time + record_.dead_time - impact.time) / at_.jitter;
    const double window = share_below(to) - share_below(from);
    const Explained& all = explained[static_cast<std::size_t>(knock - record_.knocks.begin())];
    Vector of_bump = Vector::Zero(slopes ? knock_unknowns : 0);
    const double own =
        from < -reach ? 0 : bump(*knock, impact, slopes ? &of_bump : nullptr) / all.density;
    result.part -= (1 - own) * window;
    result.by_time += (1 - own) * (gaussian(to) - gaussian(from)) / at_.jitter;
    result.by_jitter += (1 - own) * (to * gaussian(to) - from * gaussian(from));
    if (slopes) result.by_owner += window * (of_bump / all.density - own * all.slopes);
  }
  result.part = std::max(result.part, 0.0);
  return result;
}

double KnockDensity::bump(const Knock& knock, const PredictedImpact& impact, Vector* slopes) const {
  const double width = this->width(knock.time);
  const double narrowing = at_.jitter * at_.jitter / (width * width);
  const double z = (knock.time - impact.time) / width;
  const double recorded = wall_share(impact);
  double bump = recorded * gaussian(z) / width;
  double by_log_speed = 0;
  double by_scatter = 0;
  double by_limit = 0;
  const double above = margin(impact);
  if (strengths_ && *knock.strength >= record_.saturation) {
    const double u = (impact.log_speed - std::log(record_.saturation / at_.gain)) / at_.scatter;
    const double share = share_below(u);
    if (share == 0) return 0;
    bump *= share;
    by_log_speed = gaussian(u) / share / at_.scatter;
    by_scatter = -u * gaussian(u) / share;
  } else if (strengths_) {
    const double u = (std::log(*knock.strength / at_.gain) - impact.log_speed) / at_.scatter;
    bump *= gaussian(u) / at_.scatter;
    by_log_speed = u / at_.scatter;
    by_scatter = u * u - 1;
  } else {
    const double share = share_below(above);
    if (share == 0) return 0;
    bump *= share;
    by_log_speed = gaussian(above) / share / at_.scatter;
    by_limit = -by_log_speed;
  }
  if (slopes == nullptr) return bump;
  add(slopes, impact, bump * z / width, bump * by_log_speed);
  (*slopes)[coordinate::jitter] += bump * (z * z - 1) * narrowing;
  (*slopes)[share_of(impact.wall)] += bump * (1 - recorded);
  (*slopes)[coordinate::detection_limit] += bump * by_limit;
  (*slopes)[coordinate::gain] += bump * by_log_speed;
  (*slopes)[coordinate::scatter] += bump * by_scatter;
  return bump;
}

double KnockDensity::log_at(const Knock& knock, Vector* slopes, double factor) const {
  check_time_limit();  // many impacts are within the reach of a large jitter
  const double spurious = at_.spurious_rate / strength_range_;
  double density = spurious;
  const double width = this->width(knock.time);
  const auto first =
      std::ranges::lower_bound(impacts_, knock.time - reach * width, {}, &PredictedImpact::time);
  Vector sum = Vector::Zero(slopes != nullptr ? knock_unknowns : 0);
  for (auto impact = first; impact != impacts_.end(); ++impact) {
    if (knock.time - impact->time < -reach * width) break;
    density += bump(knock, *impact, slopes != nullptr ? &sum : nullptr);
  }
  if (slopes != nullptr) {
    sum[coordinate::spurious_rate] += spurious;
    *slopes += factor / density * sum;
  }
  return std::log(density);
}

double KnockDensity::expected(Vector* slopes) const {
  const double deaf =
      blur_ > 0 ? 0 : record_.dead_time * static_cast<double>(record_.knocks.size());
  double sum = at_.spurious_rate * (record_.duration() - deaf);
  if (slopes != nullptr) (*slopes)[coordinate::spurious_rate] += sum;
  const std::vector<Explained> explained = this->explained(slopes != nullptr);
  for (const PredictedImpact& impact : impacts_) {
    const Heard heard = this->heard(impact, explained);
    const double above = margin(impact);
    const double recorded = wall_share(impact);
    const double share = recorded * share_below(above);
    sum += share * heard.part;
    if (slopes == nullptr) continue;
    const double steepness = recorded * gaussian(above) / at_.scatter * heard.part;
    add(slopes, impact, share * heard.by_time, steepness);
    if (heard.by_owner.size() > 0) *slopes += share * heard.by_owner;
    (*slopes)[share_of(impact.wall)] += share * heard.part * (1 - recorded);
    (*slopes)[coordinate::jitter] += share * heard.by_jitter;
    (*slopes)[coordinate::detection_limit] -= steepness;
    (*slopes)[coordinate::gain] += steepness;
    if (strengths_) (*slopes)[coordinate::scatter] -= steepness * above * at_.scatter;
  }
  return sum;
}

KnockDensity::Information KnockDensity::information() const {
  Information result{Matrix::Zero(knock_unknowns, knock_unknowns),
                     Matrix::Zero(knock_unknowns, knock_unknowns)};
  constexpr double step = 0.5;
  constexpr double end = 5;
  constexpr double step_of_strength = 1;  // of a smoother integrand
  const double last_strength = strengths_ ? 4 : 0;
  double covered = 0;
  Vector slopes(knock_unknowns);
  const std::vector<Explained> explained = this->explained(false);
  for (const PredictedImpact& impact : impacts_) {
    if (recorded_share(impact) < 1e-6) continue;
    if (impact.time < record_.from || impact.time > record_.to) continue;
    // With strengths the sum below leaves out what is not detected.
    const double share =
        (strengths_ ? wall_share(impact) : recorded_share(impact)) * heard(impact, explained).part;
    Vector mean = Vector::Zero(knock_unknowns);
    for (double z = -end; z <= end; z += step) {
      for (double u = -last_strength; u <= last_strength; u += step_of_strength) {
        Knock knock{impact.time + z * width(impact.time)};
        double weight = gaussian(z) * step;
        if (strengths_) {
          if (u < -margin(impact)) continue;  // not detected
          knock.strength =
              std::min(at_.gain * std::exp(impact.log_speed + u * at_.scatter), record_.saturation);
          weight *= gaussian(u) * step_of_strength;
        }
        slopes.setZero();
        const double density = std::exp(log_at(knock, &slopes));
        // What is spurious here belongs to the impacts in proportion to their densities.
        const double spurious = at_.spurious_rate / strength_range_;
        const double stretch = density / std::max(density - spurious, 1e-3 * density);
        result.information += weight * share * stretch * slopes * slopes.transpose();
        covered += weight * share * (stretch - 1);
        mean += weight * share * slopes;
      }
    }
    result.score -= mean * mean.transpose();
  }
  const double elsewhere = std::max(0.0, at_.spurious_rate * record_.duration() - covered);
  result.information(coordinate::spurious_rate, coordinate::spurious_rate) += elsewhere;
  result.score += result.information;
  return result;
}

}  // namespace ricochet::carrier_track::inline identification
