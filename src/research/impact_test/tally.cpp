#include "src/research/impact_test/tally.h"

#include <algorithm>

namespace ricochet::studies::impact_test {
namespace {

/// What the scores that have a number have.
std::vector<double> numbers_of(const std::vector<const Score*>& scores,
                               std::optional<double> Score::*member) {
  std::vector<double> numbers;
  for (const Score* score : scores) {
    if (score->*member) numbers.push_back(*(score->*member));
  }
  return numbers;
}

std::optional<double> largest_of(const std::vector<double>& numbers) {
  if (numbers.empty()) return std::nullopt;
  return std::ranges::max(numbers);
}

}  // namespace

void Tally::add(const Score& score) {
  ++scenes;
  answered += score.ending == Ending::answered ? 1 : 0;
  cannot += score.ending == Ending::cannot ? 1 : 0;
  errors += score.ending == Ending::error ? 1 : 0;
  never += score.ending == Ending::never ? 1 : 0;
  impacts += score.impacts;
  missed += score.missed;
  invented += score.invented;
  late += score.late;
  wrong_speed += score.wrong_speed;
}

std::optional<double> Tally::per_thousand(int number) const {
  if (impacts == 0) return std::nullopt;
  return 1000.0 * number / impacts;
}

Tally tally_of(const std::vector<Score>& scores, const std::vector<ScoredScene>& scenes,
               const std::function<bool(const TestScene&)>& counts) {
  Tally tally;
  std::vector<const Score*> chosen;
  for (std::size_t k = 0; k < scores.size(); ++k) {
    if (!counts(scenes[k].scene)) continue;
    tally.add(scores[k]);
    chosen.push_back(&scores[k]);
  }
  const std::vector<double> gained = numbers_of(chosen, &Score::energy_gained);
  tally.time_error = median_of(numbers_of(chosen, &Score::time_error));
  tally.penetration = largest_of(numbers_of(chosen, &Score::penetration));
  tally.energy_gained = median_of(gained);
  tally.most_energy_gained = largest_of(gained);
  tally.seconds_per_impact = median_of(numbers_of(chosen, &Score::seconds_per_impact));
  return tally;
}

std::optional<double> median_of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

std::optional<double> time_ratio(const std::vector<Score>& scores,
                                 const std::vector<Score>& other) {
  std::vector<double> ratios;
  for (std::size_t k = 0; k < std::min(scores.size(), other.size()); ++k) {
    const auto &own = scores[k].seconds_per_impact, &its = other[k].seconds_per_impact;
    if (own && its && *its > 0) ratios.push_back(*own / *its);
  }
  return median_of(std::move(ratios));
}

}  // namespace ricochet::studies::impact_test
