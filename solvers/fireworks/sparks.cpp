#include "solvers/fireworks/sparks.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace ricochet::fireworks {

namespace {

/// Sparks at either end of the order.
std::size_t number_of(std::span<const Eigen::Index> order, double share) {
  const auto some = std::max(1L, std::lround(share * static_cast<double>(order.size())));
  return std::min(static_cast<std::size_t>(some), order.size());
}

}  // namespace

int scaled_sparks(int published, std::int64_t budget) {
  constexpr double published_budget = 300'000;
  constexpr long least = 5;
  const double factor = std::sqrt(static_cast<double>(budget) / published_budget);
  const auto some = std::lround(published * std::min(factor, 1.0));
  return static_cast<int>(std::max(some, std::min<long>(least, published)));
}

void displace(Vector& x, std::span<const Eigen::Index> moved, double amplitude, const Vector& unit,
              Offsets offsets, Random& random) {
  if (offsets == Offsets::one) {
    const double offset = amplitude * two_sided(random);
    for (const Eigen::Index k : moved) x[k] += offset * unit[k];
  } else {
    for (const Eigen::Index k : moved) x[k] += amplitude * two_sided(random) * unit[k];
  }
}

void multiply(Vector& x, std::span<const Eigen::Index> moved, Random& random) {
  const double factor = 1 + normal(1, random)[0];
  for (const Eigen::Index k : moved) x[k] *= factor;
}

void approach(Vector& x, std::span<const Eigen::Index> moved, const Vector& best, Random& random) {
  const double factor = normal(1, random)[0];
  for (const Eigen::Index k : moved) x[k] += (best[k] - x[k]) * factor;
}

void guide(Vector& x, const Eigen::Ref<const Matrix>& sparks, std::span<const Eigen::Index> order,
           double share, double times) {
  const std::size_t count = number_of(order, share);
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Index good = order[k];
    const Eigen::Index bad = order[order.size() - 1 - k];
    x += times * (sparks.row(good) - sparks.row(bad)).transpose() / static_cast<double>(count);
  }
}

Vector mean_of_best(const Eigen::Ref<const Matrix>& sparks, std::span<const Eigen::Index> order,
                    double share) {
  const std::size_t count = number_of(order, share);
  Vector mean = Vector::Zero(sparks.cols());
  for (std::size_t k = 0; k < count; ++k) {
    mean += sparks.row(order[k]).transpose() / static_cast<double>(count);
  }
  return mean;
}

std::vector<int> spark_counts(const Vector& fitness, const SparkCountOptions& options) {
  const double worst = fitness.maxCoeff();
  const double excess = (worst - fitness.array()).sum();
  const double fewest = options.fewest * options.sparks;
  const double most = options.most * options.sparks;
  std::vector<int> counts;
  counts.reserve(static_cast<std::size_t>(fitness.size()));
  for (const double f : fitness) {
    double share = options.sparks * (worst - f + options.epsilon) / (excess + options.epsilon);
    if (excess == 0 && options.tied == TiedShare::equal) {
      share = options.sparks / static_cast<double>(fitness.size());
    }
    if (share > most) {
      share = most;
    } else if (share < fewest || options.third_branch == ThirdBranch::as_printed) {
      share = fewest;
    }
    counts.push_back(static_cast<int>(std::round(share)));
  }
  return counts;
}

int most_sparks(int fireworks, const SparkCountOptions& options) {
  return fireworks * static_cast<int>(std::round(options.most * options.sparks));
}

void check(const SparkCountOptions& options) {
  const bool ordered = options.fewest < options.most && options.most < 1;
  if (!ordered || !(options.fewest * options.sparks >= 0.5) || !(options.sparks <= 1e6)) {
    throw std::invalid_argument(
        "sparks: needs fewest < most < 1, fewest * sparks >= 0.5 and sparks <= 1e6");
  }
  if (!(options.epsilon > 0)) throw std::invalid_argument("epsilon: must be > 0");
}

Vector explosion_amplitudes(const Vector& fitness, double amplitude, double epsilon) {
  const Vector excess = fitness.array() - fitness.minCoeff();
  return amplitude * (excess.array() + epsilon) / (excess.sum() + epsilon);
}

double AmplitudeFloor::after(double evaluations, double budget) const {
  if (!(budget > 0)) return first;
  const double t = std::clamp(evaluations / budget, 0.0, 1.0);
  return first - (first - last) * std::sqrt((2 - t) * t);
}

void check(const AmplitudeSteps& steps) {
  if (!(steps.growth >= 1 && steps.decline > 0 && steps.decline <= 1)) {
    throw std::invalid_argument("amplitude steps: need growth >= 1 and 0 < decline <= 1");
  }
}

std::span<const Eigen::Index> Coordinates::first(std::size_t count, Random& random) {
  if (count < all_.size()) {
    for (std::size_t i = 0; i < count; ++i) {
      std::swap(all_[i], all_[i + one_of(all_.size() - i, random)]);
    }
  }
  return {all_.data(), count};
}

std::span<const Eigen::Index> Coordinates::draw(Moved moved, Random& random) {
  const auto dimension = static_cast<double>(all_.size());
  switch (moved) {
    case Moved::rounded:
      return first(static_cast<std::size_t>(std::round(dimension * share(random))), random);
    case Moved::ceiled:  // 1 - U is never 0
      return first(static_cast<std::size_t>(std::ceil(dimension * (1 - share(random)))), random);
    case Moved::coins: {
      std::size_t heads = 0;
      for (std::size_t i = 0; i < all_.size(); ++i) {
        if (toss(random)) std::swap(all_[heads++], all_[i]);
      }
      return {all_.data(), heads};
    }
    case Moved::all:
      break;
  }
  return all_;
}

Box::Box(const Vector& lower, const Vector& upper)
    : lower_(lower), upper_(upper), width_(upper_ - lower_) {
  for (Eigen::Index k = 0; k < width_.size(); ++k) {
    if (width_[k] > 0) free_.push_back(k);
  }
}

double Box::drawn(Eigen::Index k, Random& random) const {
  return std::min(lower_[k] + share(random) * width_[k], upper_[k]);
}

void Box::draw(Vector& x, Random& random) const {
  for (Eigen::Index k = 0; k < x.size(); ++k) x[k] = drawn(k, random);
}

void Box::bring_back(Vector& x, Mapping mapping, Random& random) const {
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    if (x[k] >= lower_[k] && x[k] <= upper_[k]) continue;
    if (mapping == Mapping::redraw) {
      x[k] = drawn(k, random);
    } else {
      const double rest = width_[k] > 0 ? std::fmod(std::abs(x[k]), width_[k]) : 0.0;
      x[k] = std::min(lower_[k] + rest, upper_[k]);
    }
  }
}

void Box::bring_near(Vector& x, const Vector& centre, double amplitude, Random& random) const {
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    if (x[k] >= lower_[k] && x[k] <= upper_[k]) continue;
    const double least = std::max(lower_[k], centre[k] - amplitude * width_[k]);
    const double most = std::min(upper_[k], centre[k] + amplitude * width_[k]);
    x[k] = std::clamp(least + share(random) * (most - least), lower_[k], upper_[k]);
  }
}

}  // namespace ricochet::fireworks
