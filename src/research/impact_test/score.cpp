#include "src/research/impact_test/score.h"

#include <algorithm>
#include <cmath>

#include "src/research/impact_test/match.h"

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

}  // namespace ricochet::studies::impact_test
