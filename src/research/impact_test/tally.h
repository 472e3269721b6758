#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "src/research/impact_test/score.h"

namespace ricochet::studies::impact_test {

/// Scores of some scenes, added up. Per 1,000: of the true impacts in the scenes that the tool can
/// express; those of scenes without an answer are missed.
struct Tally {
  int scenes = 0, answered = 0, cannot = 0, errors = 0, never = 0;
  int impacts = 0, missed = 0, invented = 0, late = 0, wrong_speed = 0;
  std::optional<double> time_error;   ///< median over scenes, in mean times between impacts
  std::optional<double> penetration;  ///< [m], largest
  std::optional<double> energy_gained, most_energy_gained;  ///< median and largest over scenes
  std::optional<double> seconds_per_impact;                 ///< [s], median over scenes

  void add(const Score& score);
  std::optional<double> per_thousand(int number) const;
};

/// The scores of the scenes for which `counts` is true.
Tally tally_of(const std::vector<Score>& scores, const std::vector<ScoredScene>& scenes,
               const std::function<bool(const TestScene&)>& counts);

/// The median; nothing for an empty list.
std::optional<double> median_of(std::vector<double> values);

/// The median, over the scenes that both have answered, of the time of the first over that of the
/// other.
std::optional<double> time_ratio(const std::vector<Score>& scores, const std::vector<Score>& other);

}  // namespace ricochet::studies::impact_test
