#include "src/benchmark/statistics/rivals_ahead.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

namespace ricochet {

RivalsAhead rivals_ahead(const std::vector<Ranking>& instances) {
  RivalsAhead all;
  for (const Ranking& ranking : instances) {
    std::map<std::size_t, double> ahead;
    double before = 0;
    for (const auto& tied : ranking) {
      const auto others = static_cast<double>(tied.size()) - 1;
      for (const std::size_t entry : tied) ahead[entry] = before + others / 2;
      before += others + 1;
    }
    std::vector<std::size_t> entries;
    std::vector<double> shares;
    for (const auto& [entry, number] : ahead) {
      entries.push_back(entry);
      shares.push_back(number / (before - 1));
    }
    if (!all.of_instance.empty() && entries != all.entries) {
      throw std::invalid_argument("rivals_ahead: the instances were ranked for different entries");
    }
    all.entries = std::move(entries);
    all.of_instance.push_back(std::move(shares));
  }
  return all.entries.size() < 2 ? RivalsAhead() : all;
}

std::vector<std::optional<double>> mean_rivals_ahead(const std::vector<RivalsAhead>& problems,
                                                     std::size_t entries) {
  std::vector<double> sums(entries);
  std::vector<int> taken(entries);
  for (const RivalsAhead& problem : problems) {
    for (std::size_t k = 0; k < problem.entries.size(); ++k) {
      double sum = 0;
      for (const auto& shares : problem.of_instance) sum += shares[k];
      sums[problem.entries[k]] += sum / static_cast<double>(problem.of_instance.size());
      ++taken[problem.entries[k]];
    }
  }
  std::vector<std::optional<double>> means(entries);
  for (std::size_t e = 0; e < entries; ++e) {
    // Rounded, so that equals stay equal in whatever order the problems come.
    if (taken[e] > 0) means[e] = std::round(1e12 * sums[e] / taken[e]) / 1e12;
  }
  return means;
}

std::vector<std::size_t> first_of(const std::vector<std::optional<double>>& means) {
  constexpr double rounding = 1e-12;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& mean : means) least = std::min(least, mean.value_or(least));
  std::vector<std::size_t> first;
  for (std::size_t e = 0; e < means.size(); ++e) {
    if (means[e] && *means[e] <= least + rounding) first.push_back(e);
  }
  return first;
}

}  // namespace ricochet
