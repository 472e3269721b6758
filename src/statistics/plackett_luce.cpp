#include "src/statistics/plackett_luce.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "src/core/random.h"
#include "src/statistics/bootstrap.h"
#include "src/statistics/confidence.h"

namespace ricochet {
namespace {

constexpr int tie_orders = 400;
constexpr int settling = 5;  // sweeps after another order of the ties
constexpr int kept = 20;     // sweeps for each

using Order = std::vector<std::size_t>;

double exponential(Random& random) {
  return -std::log1p(-uniform(random));
}

/// Of the shape given, >= 1, and scale 1 (Marsaglia and Tsang 2000, doi:10.1145/358407.358414).
double gamma(double shape, Random& random) {
  const double d = shape - 1.0 / 3;
  for (;;) {
    const double x = normal(1, random)[0];
    const double v = std::pow(1 + x / std::sqrt(9 * d), 3);
    if (v > 0 && -exponential(random) < x * x / 2 + d * (1 - v + std::log(v))) return d * v;
  }
}

/// The ranking with its ties broken, each order alike likely.
Order order_of(const Ranking& ranking, Random& random) {
  Order order;
  for (const auto& tied : ranking) {
    const std::size_t first = order.size();
    for (const std::size_t solver : tied) {
      const auto new_place =
          static_cast<std::size_t>(static_cast<double>(order.size() - first + 1) * uniform(random));
      order.push_back(solver);
      std::swap(order.back(), order[first + new_place]);
    }
  }
  return order;
}

/// One sweep: at each place an exponential time at the rate of the weights still standing, then
/// each weight from the times that it stood and how often it was chosen. Their sum, of which
/// rankings say nothing, is drawn anew.
void sweep(const std::vector<Order>& orders, std::vector<double>& weights, Random& random) {
  std::vector<double> shape(weights.size(), 1.0);
  std::vector<double> rate(weights.size(), 1.0);
  for (const Order& order : orders) {
    std::vector<double> standing(order.size());
    double sum = 0;
    for (std::size_t i = order.size(); i-- > 0;) standing[i] = sum += weights[order[i]];
    double stood = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i + 1 < order.size()) {  // nobody is left to be chosen from at the last place
        stood += exponential(random) / standing[i];
        ++shape[order[i]];
      }
      rate[order[i]] += stood;
    }
  }
  double sum = 0;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    sum += weights[k] = gamma(shape[k], random) / rate[k];
  }
  const double scale = gamma(static_cast<double>(weights.size()), random) / sum;
  for (double& weight : weights) weight *= scale;
}

void check(const std::vector<Ranking>& rankings, std::size_t solvers) {
  for (const Ranking& ranking : rankings) {
    std::vector<bool> seen(solvers);
    for (const auto& tied : ranking) {
      for (const std::size_t solver : tied) {
        if (solver >= solvers || seen[solver]) {
          throw std::invalid_argument("plackett_luce: a ranking names each of its solvers once");
        }
        seen[solver] = true;
      }
    }
  }
}

}  // namespace

std::vector<Strength> plackett_luce(const std::vector<Ranking>& rankings, std::size_t solvers,
                                    std::uint64_t seed, double confidence) {
  check_confidence(confidence);
  check(rankings, solvers);
  if (solvers == 0) return {};
  Random random(seed);
  std::vector<double> weights(solvers, 1.0);
  std::vector<std::vector<double>> drawn(solvers);
  std::vector<int> best(solvers);
  std::vector<Order> orders(rankings.size());
  for (int i = 0; i < tie_orders * (settling + kept); ++i) {
    if (i % (settling + kept) == 0) {
      for (std::size_t k = 0; k < rankings.size(); ++k) orders[k] = order_of(rankings[k], random);
    }
    sweep(orders, weights, random);
    if (i % (settling + kept) < settling) continue;
    double sum = 0;
    for (const double weight : weights) sum += weight;
    for (std::size_t k = 0; k < solvers; ++k) drawn[k].push_back(weights[k] / sum);
    ++best[static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) -
                                    weights.begin())];
  }
  std::vector<Strength> strengths;
  for (std::size_t k = 0; k < solvers; ++k) {
    const auto draws = static_cast<double>(drawn[k].size());
    double sum = 0;
    for (const double weight : drawn[k]) sum += weight;
    strengths.push_back({.weight = sum / draws,
                         .weight_interval = {quantile(drawn[k], (1 - confidence) / 2),
                                             quantile(drawn[k], (1 + confidence) / 2)},
                         .probability_of_being_best = best[k] / draws});
  }
  return strengths;
}

}  // namespace ricochet
