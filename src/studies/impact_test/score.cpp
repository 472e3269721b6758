#include "src/studies/impact_test/score.h"

#include <algorithm>
#include <cmath>

namespace ricochet::studies::impact_test {

namespace {

using carrier_track::Impact;

constexpr double partners_apart = 0.5;  // mean times between impacts
constexpr double late = 0.01;           // the same
constexpr double wrong_speed = 0.01;    // relative

/// Of more impacts than this those beyond have no partners: a tool that rattles without end.
constexpr std::size_t most_found = 20'000;

double energy_of(const std::vector<Impact>& impacts, double slowest) {
  double sum = 0;
  for (const Impact& i : impacts) sum += i.speed > slowest ? i.speed * i.speed : 0;
  return sum;
}

std::vector<Impact> listed(const Truth& truth) {
  std::vector<Impact> impacts;
  for (const TrueImpact& i : truth) impacts.push_back({i.time, i.wall, i.speed});
  return impacts;
}

/// Compares the impacts of both lists, which have those faster than half of `slowest`.
class Comparison {
 public:
  Comparison(const std::vector<Impact>& true_ones, const std::vector<Impact>& found, double slowest,
             double mean_time)
      : true_(true_ones), found_(found), slowest_(slowest), mean_time_(mean_time) {
    const std::vector<Impact> first(
        found.begin(),
        found.begin() + static_cast<std::ptrdiff_t>(std::min(most_found, found.size())));
    partners_ = partners_of(true_ones, first, partners_apart * mean_time);
  }

  void add_to(Score& score) const {
    std::vector<char> has_partner(found_.size());
    double until = first_loss();
    for (std::size_t k = 0; k < true_.size(); ++k) {
      const bool counts = true_[k].speed > slowest_;
      if (!partners_[k]) {
        score.missed += counts ? 1 : 0;
        continue;
      }
      const Impact& found = found_[*partners_[k]];
      has_partner[*partners_[k]] = 1;
      const double apart = std::abs(found.time - true_[k].time) / mean_time_;
      if (true_[k].time < until) score.time_error = std::max(score.time_error.value_or(0), apart);
      if (!counts) continue;
      if (apart > late) {
        ++score.late;
      } else if (std::abs(found.speed - true_[k].speed) > wrong_speed * true_[k].speed) {
        ++score.wrong_speed;
      }
    }
    for (std::size_t j = 0; j < found_.size(); ++j) {
      score.invented += found_[j].speed > slowest_ && has_partner[j] == 0 ? 1 : 0;
    }
  }

 private:
  /// The time of the first impact that counts and has no partner.
  double first_loss() const {
    double first = std::numeric_limits<double>::infinity();
    std::vector<char> has_partner(found_.size());
    for (std::size_t k = 0; k < true_.size(); ++k) {
      if (partners_[k]) {
        has_partner[*partners_[k]] = 1;
      } else if (true_[k].speed > slowest_) {
        first = std::min(first, true_[k].time);
      }
    }
    for (std::size_t j = 0; j < found_.size(); ++j) {
      if (found_[j].speed > slowest_ && has_partner[j] == 0)
        first = std::min(first, found_[j].time);
    }
    return first;
  }

  const std::vector<Impact>&true_, &found_;
  const double slowest_, mean_time_;
  std::vector<std::optional<std::size_t>> partners_;
};

}  // namespace

Score score_of(const Answer& answer, const ScoredScene& scored) {
  Score score{answer.ending};
  if (answer.ending == Ending::cannot) return score;
  score.impacts = scored_impacts(scored.scene, scored.truth);
  if (answer.ending != Ending::answered) {
    score.missed = score.impacts;
    return score;
  }
  const double slowest = scored.scene.slowest;
  std::vector<Impact> found;
  std::ranges::copy_if(answer.impacts, std::back_inserter(found), [&](const Impact& i) {
    return i.speed > slowest / 2 && i.time <= scored.scene.duration;
  });
  const std::vector<Impact> true_ones = listed(scored.truth);
  const double mean_time = mean_time_between(scored.scene, scored.truth);
  Comparison(true_ones, found, slowest, mean_time).add_to(score);
  score.penetration = answer.deepest;
  score.energy_gained = energy_of(found, slowest) / energy_of(true_ones, slowest) - 1;
  score.seconds_per_impact = answer.seconds / score.impacts;
  return score;
}

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

namespace {

using carrier_track::Wall;

std::vector<std::size_t> places_on(Wall wall, const std::vector<Impact>& impacts) {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < impacts.size(); ++k) {
    if (impacts[k].wall == wall) places.push_back(k);
  }
  return places;
}

/// The best pairing of the impacts on one wall, by dynamic programming over the beginnings of both
/// lists.
class Pairing {
 public:
  Pairing(const std::vector<Impact>& rows, const std::vector<Impact>& columns, Wall wall,
          double apart)
      : rows_(rows),
        columns_(columns),
        row_(places_on(wall, rows)),
        column_(places_on(wall, columns)),
        apart_(apart),
        worth_((row_.size() + 1) * (column_.size() + 1)) {
    for (std::size_t i = 1; i <= row_.size(); ++i) {
      for (std::size_t j = 1; j <= column_.size(); ++j) {
        double best = std::max(worth(i - 1, j), worth(i, j - 1));
        const double with_pair = worth(i - 1, j - 1) + worth_of_pair(i, j);
        worth_[i * (column_.size() + 1) + j] = std::max(best, with_pair);
      }
    }
  }

  void write(std::vector<std::optional<std::size_t>>& partners) const {
    std::size_t i = row_.size();
    std::size_t j = column_.size();
    while (i > 0 && j > 0) {
      if (worth(i, j) == worth(i - 1, j)) {
        --i;
      } else if (worth(i, j) == worth(i, j - 1)) {
        --j;
      } else {
        partners[row_[--i]] = column_[--j];
      }
    }
  }

 private:
  double worth(std::size_t i, std::size_t j) const { return worth_[i * (column_.size() + 1) + j]; }

  /// One pair more is worth more than any sum of differences; nothing for those too far apart.
  double worth_of_pair(std::size_t i, std::size_t j) const {
    const double difference =
        std::abs(rows_[row_[i - 1]].time - columns_[column_[j - 1]].time) / apart_;
    if (!(difference <= 1)) return 0;
    return static_cast<double>(row_.size() + 1) - difference;
  }

  const std::vector<Impact>&rows_, &columns_;
  const std::vector<std::size_t> row_, column_;
  const double apart_;
  std::vector<double> worth_;
};

}  // namespace

std::vector<std::optional<std::size_t>> partners_of(const std::vector<Impact>& true_ones,
                                                    const std::vector<Impact>& found,
                                                    double apart) {
  std::vector<std::optional<std::size_t>> partners(true_ones.size());
  for (const Wall wall : {Wall::lower, Wall::upper}) {
    Pairing(true_ones, found, wall, apart).write(partners);
  }
  return partners;
}

}  // namespace ricochet::studies::impact_test
