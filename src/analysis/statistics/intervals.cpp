#include "src/analysis/statistics/intervals.h"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>

#include "ricochet/random.h"

namespace ricochet {

Interval wilson_interval(double successes, double trials, double confidence) {
  check_confidence(confidence);
  if (!(trials > 0 && successes >= 0 && successes <= trials)) {
    throw std::invalid_argument("wilson_interval: 0 <= successes <= trials and a trial are needed");
  }
  const double z = boost::math::quantile(boost::math::normal(), (1 + confidence) / 2);
  const double failures = trials - successes;
  const double centre = successes + z * z / 2;
  const double half = z * std::sqrt(successes * failures / trials + z * z / 4);
  // For no success or no failure one end is exactly 0 or 1, despite rounding.
  return {successes == 0 ? 0 : std::max(0.0, (centre - half) / (trials + z * z)),
          failures == 0 ? 1 : std::min(1.0, (centre + half) / (trials + z * z))};
}

std::vector<std::vector<std::size_t>> places_by_cluster(const std::vector<std::string>& clusters) {
  std::vector<std::vector<std::size_t>> groups;
  std::map<std::string, std::size_t> known;
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    const std::size_t group = clusters[k].empty()
                                  ? groups.size()
                                  : known.try_emplace(clusters[k], groups.size()).first->second;
    if (group == groups.size()) groups.emplace_back();
    groups[group].push_back(k);
  }
  return groups;
}

namespace {

/// The values of each cluster.
std::vector<std::vector<double>> by_cluster(const std::vector<double>& shares,
                                            const std::vector<std::string>& clusters) {
  std::vector<std::vector<double>> groups;
  for (const auto& places :
       places_by_cluster(clusters.empty() ? std::vector<std::string>(shares.size()) : clusters)) {
    auto& group = groups.emplace_back();
    for (const std::size_t k : places) group.push_back(shares[k]);
  }
  return groups;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

/// The variance of the mean of all values, whose clusters were drawn; `imagined` of a cluster is
/// added at either end of [0, 1].
double variance_of_mean(const std::vector<std::vector<double>>& clusters, double mean,
                        double imagined) {
  const auto number = static_cast<double>(clusters.size());
  double size = 0;
  for (const auto& cluster : clusters) size += static_cast<double>(cluster.size());
  const double usual = size / number;
  double squares = imagined * usual * usual * (mean * mean + (1 - mean) * (1 - mean));
  for (const auto& cluster : clusters) {
    double deviation = 0;
    for (const double value : cluster) deviation += value - mean;
    squares += deviation * deviation;
  }
  return number * squares / ((number - 1 + imagined) * size * size);
}

}  // namespace

MeanShare mean_share(const std::vector<double>& shares, const std::vector<std::string>& clusters,
                     double confidence) {
  constexpr double imagined = 0.1;
  check_confidence(confidence);
  if (shares.empty()) throw std::invalid_argument("mean_share: no values");
  if (!clusters.empty() && clusters.size() != shares.size()) {
    throw std::invalid_argument("mean_share: each value needs its cluster");
  }
  for (const double share : shares) {
    if (!(share >= 0 && share <= 1))
      throw std::invalid_argument("mean_share: a value not in [0, 1]");
  }
  const auto groups = by_cluster(shares, clusters);
  const double mean = std::min(1.0, mean_of(shares));
  const auto size = static_cast<double>(shares.size());
  double squared_sizes = 0;
  for (const auto& group : groups) squared_sizes += std::pow(static_cast<double>(group.size()), 2);
  // Values in [0, 1] vary most if all of a cluster are 0, or all are 1.
  double trials = std::max(size * size / squared_sizes,
                           mean * (1 - mean) / variance_of_mean(groups, mean, imagined));
  // Of problems that are alone in their clusters the pseudo-observations make up for Student's t.
  if (groups.size() > 1 && groups.size() < shares.size()) {
    const double place = (1 + confidence) / 2;
    const double normal = boost::math::quantile(boost::math::normal(), place);
    const double few = boost::math::quantile(
        boost::math::students_t(static_cast<double>(groups.size() - 1)), place);
    trials *= std::pow(normal / few, 2);
  }
  return {mean, wilson_interval(mean * trials, trials, confidence)};
}

double effective_problems(const std::vector<std::vector<double>>& entries,
                          const std::vector<std::string>& clusters) {
  double independent = 0, clustered = 0;
  for (const std::vector<double>& shares : entries) {
    const double mean = mean_of(shares);
    independent += variance_of_mean(by_cluster(shares, {}), mean, 0);
    clustered += variance_of_mean(by_cluster(shares, clusters), mean, 0);
  }
  const auto size = static_cast<double>(clusters.size());
  return clustered > independent ? size * independent / clustered : size;
}

double coverage_of_mean_share(const std::vector<std::vector<double>>& entries,
                              const std::vector<std::string>& clusters, bool known,
                              std::uint64_t seed, int samples) {
  Random random(seed);
  double covered = 0, all = 0;
  for (const std::vector<double>& shares : entries) {
    const auto groups = by_cluster(shares, clusters);
    const double truth = mean_of(shares);
    for (int k = 0; k < samples; ++k) {
      std::vector<double> drawn;
      std::vector<std::string> names;
      for (std::size_t i = 0; i < groups.size(); ++i) {
        const double place = uniform(random) * static_cast<double>(groups.size());
        const auto& group = groups[static_cast<std::size_t>(place)];
        drawn.insert(drawn.end(), group.begin(), group.end());
        names.resize(drawn.size(), std::to_string(i));
      }
      if (!known) names.clear();
      const Interval interval = mean_share(drawn, names).interval;
      covered += interval.lower <= truth && truth <= interval.upper ? 1 : 0;
      all += 1;
    }
  }
  return covered / all;
}

double quantile(std::vector<double> sample, double q) {
  const double place = q * static_cast<double>(sample.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const double share = place - static_cast<double>(below);
  const auto at_low = sample.begin() + static_cast<std::ptrdiff_t>(below);
  std::nth_element(sample.begin(), at_low, sample.end());
  const double low = *at_low;
  if (share == 0.0) return low;
  const double high = *std::min_element(at_low + 1, sample.end());
  return std::isinf(high) ? high : low + share * (high - low);
}

double root_mean_square(const std::vector<double>& errors) {
  double squares = 0;
  for (const double error : errors) squares += error * error;
  return std::sqrt(squares / static_cast<double>(errors.size()));
}

Interval root_mean_square_interval(const std::vector<std::vector<double>>& groups,
                                   double confidence, int resamples, std::uint64_t seed) {
  Random random(seed);
  const auto size = static_cast<double>(groups.size());
  std::vector<double> means;
  std::vector<double> drawn;
  for (int k = 0; k < resamples; ++k) {
    drawn.clear();
    for (std::size_t i = 0; i < groups.size(); ++i) {
      const auto& group = groups[static_cast<std::size_t>(size * uniform(random))];
      drawn.insert(drawn.end(), group.begin(), group.end());
    }
    means.push_back(root_mean_square(drawn));
  }
  return {quantile(means, (1 - confidence) / 2), quantile(means, (1 + confidence) / 2)};
}

}  // namespace ricochet
