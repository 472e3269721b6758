#include "src/benchmark/statistics/probability_of_being_first.h"

#include <stdexcept>

#include "ricochet/random.h"

namespace ricochet {
namespace {

std::size_t drawn_below(std::size_t size, Random& random) {
  return static_cast<std::size_t>(static_cast<double>(size) * uniform(random));
}

}  // namespace

std::vector<double> probabilities_of_being_first(const std::vector<RivalsAhead>& problems,
                                                 std::size_t entries, std::uint64_t seed,
                                                 int resamples) {
  if (problems.size() < 2 || resamples < 1) {
    throw std::invalid_argument(
        "probabilities_of_being_first: two problems and a sample are needed");
  }
  Random random(seed);
  std::vector<double> times(entries);
  for (int i = 0; i < resamples; ++i) {
    std::vector<double> sums(entries);
    std::vector<int> taken(entries);
    for (std::size_t draw = 0; draw < problems.size(); ++draw) {
      const RivalsAhead& problem = problems[drawn_below(problems.size(), random)];
      const std::size_t instances = problem.of_instance.size();
      for (std::size_t k = 0; k < instances; ++k) {
        const std::vector<double>& shares = problem.of_instance[drawn_below(instances, random)];
        for (std::size_t e = 0; e < shares.size(); ++e) {
          sums[problem.entries[e]] += shares[e] / static_cast<double>(instances);
        }
      }
      for (const std::size_t e : problem.entries) ++taken[e];
    }
    std::vector<std::optional<double>> means(entries);
    for (std::size_t e = 0; e < entries; ++e) {
      if (taken[e] > 0) means[e] = sums[e] / taken[e];
    }
    const std::vector<std::size_t> first = first_of(means);
    for (const std::size_t e : first) times[e] += 1 / static_cast<double>(first.size());
  }
  for (double& share : times) share /= resamples;
  return times;
}

}  // namespace ricochet
