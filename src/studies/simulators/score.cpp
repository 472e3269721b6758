#include <algorithm>
#include <cmath>
#include <limits>

#include "src/studies/simulators/suite.h"

namespace ricochet::studies::simulators {

namespace {

constexpr double partners_apart = 0.5;  // mean times between impacts
constexpr double late = 0.01;           // the same
constexpr double wrong_speed = 0.01;    // relative

/// Of more impacts than this those beyond have no partners: a tool that rattles without end.
constexpr std::size_t most_found = 20'000;

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
  std::vector<Impact> true_ones, found;
  for (const TrueImpact& i : scored.truth) true_ones.push_back({i.time, i.wall, i.speed});
  std::ranges::copy_if(answer.impacts, std::back_inserter(found), [&](const Impact& i) {
    return i.speed > slowest / 2 && i.time <= scored.scene.duration;
  });
  const std::span first(found.data(), std::min(most_found, found.size()));
  const double mean_time = mean_time_between(scored.scene, scored.truth);
  const auto partners =
      partners_of(true_ones, {first.begin(), first.end()}, partners_apart * mean_time);

  std::vector<char> has_partner(found.size());
  double first_wrong = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < true_ones.size(); ++k) {
    if (partners[k]) has_partner[*partners[k]] = 1;
    if (partners[k] || true_ones[k].speed <= slowest) continue;
    ++score.missed;
    first_wrong = std::min(first_wrong, true_ones[k].time);
  }
  for (std::size_t j = 0; j < found.size(); ++j) {
    if (has_partner[j] != 0 || found[j].speed <= slowest) continue;
    ++score.invented;
    first_wrong = std::min(first_wrong, found[j].time);
  }
  for (std::size_t k = 0; k < true_ones.size(); ++k) {
    if (!partners[k]) continue;
    const Impact &one = true_ones[k], &partner = found[*partners[k]];
    const double apart = std::abs(partner.time - one.time) / mean_time;
    if (one.time < first_wrong) score.time_error = std::max(score.time_error.value_or(0), apart);
    if (one.speed <= slowest) continue;
    if (apart > late) {
      ++score.late;
    } else if (std::abs(partner.speed - one.speed) > wrong_speed * one.speed) {
      ++score.wrong_speed;
    }
  }
  score.penetration = answer.deepest;
  score.seconds_per_impact = answer.seconds / score.impacts;
  return score;
}

std::optional<double> median_of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

std::optional<double> Tally::per_thousand(int number) const {
  if (impacts == 0) return std::nullopt;
  return 1000.0 * number / impacts;
}

Tally tally_of(const std::vector<Score>& scores) {
  Tally tally;
  for (const Score& score : scores) {
    ++tally.scenes;
    tally.answered += score.ending == Ending::answered ? 1 : 0;
    tally.cannot += score.ending == Ending::cannot ? 1 : 0;
    tally.errors += score.ending == Ending::error ? 1 : 0;
    tally.never += score.ending == Ending::never ? 1 : 0;
    tally.impacts += score.impacts;
    tally.missed += score.missed;
    tally.invented += score.invented;
    tally.late += score.late;
    tally.wrong_speed += score.wrong_speed;
  }
  const auto numbers = [&](std::optional<double> Score::*member) {
    std::vector<double> there;
    for (const Score& score : scores)
      if (score.*member) there.push_back(*(score.*member));
    return there;
  };
  tally.time_error = median_of(numbers(&Score::time_error));
  for (const double depth : numbers(&Score::penetration))
    tally.penetration = std::max(tally.penetration.value_or(0), depth);
  tally.seconds_per_impact = median_of(numbers(&Score::seconds_per_impact));
  return tally;
}

namespace {

std::vector<std::size_t> places_on(Wall wall, const std::vector<Impact>& impacts) {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < impacts.size(); ++k) {
    if (impacts[k].wall == wall) places.push_back(k);
  }
  return places;
}

}  // namespace

/// By dynamic programming over the beginnings of both lists, wall by wall.
std::vector<std::optional<std::size_t>> partners_of(const std::vector<Impact>& true_ones,
                                                    const std::vector<Impact>& found,
                                                    double apart) {
  std::vector<std::optional<std::size_t>> partners(true_ones.size());
  for (const Wall wall : {Wall::lower, Wall::upper}) {
    const std::vector<std::size_t> row = places_on(wall, true_ones),
                                   column = places_on(wall, found);
    const std::size_t width = column.size() + 1;
    std::vector<double> worth((row.size() + 1) * width);  // of the best pairing of both beginnings
    for (std::size_t i = 1; i <= row.size(); ++i) {
      for (std::size_t j = 1; j <= column.size(); ++j) {
        // One pair more is worth more than any sum of differences; nothing for those too far apart.
        const double difference =
            std::abs(true_ones[row[i - 1]].time - found[column[j - 1]].time) / apart;
        const double pair =
            difference <= 1 ? static_cast<double>(row.size() + 1) - difference : 0.0;
        worth[i * width + j] = std::max({worth[(i - 1) * width + j], worth[i * width + j - 1],
                                         worth[(i - 1) * width + j - 1] + pair});
      }
    }
    for (std::size_t i = row.size(), j = column.size(); i > 0 && j > 0;) {
      const double here = worth[i * width + j];
      if (here == worth[(i - 1) * width + j]) {
        --i;
      } else if (here == worth[i * width + j - 1]) {
        --j;
      } else {
        partners[row[--i]] = column[--j];
      }
    }
  }
  return partners;
}

}  // namespace ricochet::studies::simulators
