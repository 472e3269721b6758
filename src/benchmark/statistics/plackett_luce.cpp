#include "src/benchmark/statistics/plackett_luce.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>

#include "ricochet/random.h"
#include "src/benchmark/statistics/bootstrap.h"
#include "src/benchmark/statistics/confidence.h"
#include "src/benchmark/statistics/exponential.h"

namespace ricochet {
namespace {

constexpr std::size_t chains = 8;  // fixed, whatever the number of threads

/// A draw from the gamma distribution of this shape, >= 1, and scale 1 (Marsaglia and Tsang 2000,
/// doi:10.1145/358407.358414).
double gamma(double shape, Random& random) {
  const double d = shape - 1.0 / 3;
  for (;;) {
    const double x = normal(1, random)[0];
    const double v = std::pow(1 + x / std::sqrt(9 * d), 3);
    if (v > 0 && std::log1p(-uniform(random)) < x * x / 2 + d * (1 - v + std::log(v))) return d * v;
  }
}

/// The rankings one after the other, with their ties in some order.
struct Orders {
  std::vector<std::uint32_t> solvers;
  std::vector<std::size_t> ends;                          ///< of the rankings
  std::vector<std::pair<std::size_t, std::size_t>> ties;  ///< first and end of each
  std::vector<double> named;  ///< number of rankings that name each solver

  Orders(const std::vector<Ranking>& rankings, std::size_t number) : named(number) {
    for (const Ranking& ranking : rankings) {
      for (const auto& tied : ranking) {
        const std::size_t first = solvers.size();
        for (const std::size_t solver : tied) {
          solvers.push_back(static_cast<std::uint32_t>(solver));
          ++named[solver];
        }
        if (tied.size() > 1) ties.emplace_back(first, solvers.size());
      }
      if (ends.empty() ? !solvers.empty() : solvers.size() > ends.back()) {
        ends.push_back(solvers.size());
      }
    }
  }

  /// Draws an order of each tie, all orders being equally likely.
  void shuffle_ties(Random& random) {
    for (const auto& [first, end] : ties) {
      for (std::size_t i = first + 1; i < end; ++i) {
        const auto place =
            static_cast<std::size_t>(static_cast<double>(i - first + 1) * uniform(random));
        std::swap(solvers[i], solvers[first + place]);
      }
    }
  }

  /// How often each solver was chosen. The last of a ranking is not, because no other is left.
  std::vector<double> chosen() const {
    std::vector<double> times = named;
    for (const std::size_t end : ends) --times[solvers[end - 1]];
    return times;
  }
};

/// Draws a time for each place of each order except the last, exponential with the sum of the
/// weights not yet placed as its rate. Returns, for each solver, the sum of the times until it was
/// placed plus 1, the rate of its prior. `time` draws with rate 1.
template <class Time>
std::vector<double> drawn_rates(const Orders& orders, const std::vector<double>& weights,
                                const Time& time) {
  std::vector<double> rates(weights.size(), 1.0);
  std::vector<double> standing(weights.size());
  const std::uint32_t* first = orders.solvers.data();
  for (const std::size_t place : orders.ends) {
    const std::uint32_t* const end = orders.solvers.data() + place;
    const auto size = static_cast<std::size_t>(end - first);
    double sum = 0;
    for (std::size_t i = size; i-- > 0;) standing[i] = sum += weights[first[i]];
    double stood = 0;
    for (std::size_t i = 0; i < size; ++i) {
      if (i + 1 < size) stood += time() / standing[i];
      rates[first[i]] += stood;
    }
    first = end;
  }
  return rates;
}

double sum_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// Draws each weight from its gamma distribution given the rates.
std::vector<double> drawn_weights(const std::vector<double>& chosen,
                                  const std::vector<double>& rates, Random& random) {
  std::vector<double> weights;
  for (std::size_t k = 0; k < rates.size(); ++k) {
    weights.push_back(gamma(1 + chosen[k], random) / rates[k]);
  }
  return weights;
}

/// A sweep of the sampler; returns the rates. The sum of the weights, which rankings do not
/// determine, is drawn from its prior.
std::vector<double> sweep(const Orders& orders, const std::vector<double>& chosen,
                          std::vector<double>& weights, Random& random) {
  static const Exponential exponential;
  std::vector<double> rates = drawn_rates(orders, weights, [&] { return exponential(random); });
  weights = drawn_weights(chosen, rates, random);
  const double scale = gamma(static_cast<double>(weights.size()), random) / sum_of(weights);
  for (double& weight : weights) weight *= scale;
  return rates;
}

/// The start of the sampler: weights from iterations with all times at their means, until they
/// hardly change.
std::vector<double> starting_weights(const Orders& orders) {
  const std::vector<double> chosen = orders.chosen();
  std::vector<double> weights(chosen.size(), 1.0);
  for (int i = 0; i < 100; ++i) {
    const std::vector<double> rates = drawn_rates(orders, weights, [] { return 1.0; });
    double change = 0;
    for (std::size_t k = 0; k < weights.size(); ++k) {
      const double next = (1 + chosen[k]) / rates[k];
      change = std::max(change, std::abs(next / weights[k] - 1));
      weights[k] = next;
    }
    if (change < 1e-3) break;
  }
  return weights;
}

/// The number of tie orders for each chain, and of sweeps for each order.
struct Schedule {
  int orders, settling, kept, draws_of_each;
};

/// 10,000 sweeps in all for 8,000 draws. For many rankings fewer sweeps and as many draws: there a
/// further draw from the times of a sweep costs almost nothing, and is nearly as good as one from
/// another sweep.
Schedule schedule_for(const Orders& all) {
  constexpr double most_visits = 7e7;  // visits of a place by a sweep: half a second
  constexpr double most_orders = 50;
  const auto places = static_cast<double>(all.solvers.size());
  const double sweeps = std::clamp(most_visits / std::max(1.0, places), 320.0, 10000.0) / chains;
  const int orders = static_cast<int>(std::min(most_orders, sweeps / 2));
  const int of_each = static_cast<int>(sweeps / orders);
  const int settling = all.ties.empty() ? 0 : std::max(1, of_each / 5);
  const int kept = of_each - settling;
  const int sweeps_kept = orders * kept * static_cast<int>(chains);
  return {orders, settling, kept, (8000 + sweeps_kept - 1) / sweeps_kept};
}

/// Draws of the weights, normalised to sum 1, and how often each weight was the largest.
struct Draws {
  std::vector<std::vector<double>> of_solver;
  std::vector<int> best;

  explicit Draws(std::size_t solvers) : of_solver(solvers), best(solvers) {}

  void add(const std::vector<double>& weights) {
    const double sum = sum_of(weights);
    for (std::size_t k = 0; k < weights.size(); ++k) of_solver[k].push_back(weights[k] / sum);
    ++best[static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) -
                                    weights.begin())];
  }

  void add(const Draws& others) {
    for (std::size_t k = 0; k < best.size(); ++k) {
      of_solver[k].insert(of_solver[k].end(), others.of_solver[k].begin(),
                          others.of_solver[k].end());
      best[k] += others.best[k];
    }
  }
};

Draws draws_of_chain(Orders orders, std::vector<double> weights, const Schedule& schedule,
                     Random random) {
  constexpr int settling_at_first = 10;
  Draws draws(weights.size());
  for (int i = 0; i < schedule.orders; ++i) {
    orders.shuffle_ties(random);
    const std::vector<double> chosen = orders.chosen();
    const int settling = i == 0 ? settling_at_first : schedule.settling;
    for (int k = 0; k < settling; ++k) sweep(orders, chosen, weights, random);
    for (int k = 0; k < schedule.kept; ++k) {
      const std::vector<double> rates = sweep(orders, chosen, weights, random);
      draws.add(weights);
      for (int n = 1; n < schedule.draws_of_each; ++n) {
        draws.add(drawn_weights(chosen, rates, random));
      }
    }
  }
  return draws;
}

Random generator(std::uint64_t seed, std::size_t chain) {
  std::seed_seq sequence{seed & 0xffffffffU, seed >> 32, static_cast<std::uint64_t>(chain)};
  return Random(sequence);
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
  const Orders orders(rankings, solvers);
  const std::vector<double> weights = starting_weights(orders);
  const Schedule schedule = schedule_for(orders);
  std::vector<Draws> of_chain(chains, Draws(solvers));
  tbb::parallel_for(std::size_t{0}, chains, [&](std::size_t chain) {
    of_chain[chain] = draws_of_chain(orders, weights, schedule, generator(seed, chain));
  });
  Draws draws(solvers);
  for (const Draws& others : of_chain) draws.add(others);
  std::vector<Strength> strengths;
  for (std::size_t k = 0; k < solvers; ++k) {
    const std::vector<double>& drawn = draws.of_solver[k];
    const auto size = static_cast<double>(drawn.size());
    strengths.push_back({.weight = sum_of(drawn) / size,
                         .weight_interval = {quantile(drawn, (1 - confidence) / 2),
                                             quantile(drawn, (1 + confidence) / 2)},
                         .probability_of_being_best = draws.best[k] / size});
  }
  return strengths;
}

}  // namespace ricochet
