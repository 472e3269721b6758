#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "ricochet/machine.h"
#include "src/studies/impact_test/smallest_scene.h"
#include "src/studies/impact_test/test_scene.h"

namespace ricochet::studies::impact_test {

/// An answer compared with the truth. An impact counts if it is faster than the scene's `slowest`.
/// A partner (score.h) is at most half a mean time between impacts away, and needs only half that
/// speed: so an impact just above the limit that a tool finds just below it is neither missed nor,
/// the other way round, invented.
///
/// Without an answer all impacts are missed, except if the tool cannot express the scene: then
/// nothing is scored.
struct Score {
  Ending ending = Ending::answered;
  int impacts = 0;      ///< true ones that count
  int missed = 0;       ///< of them without a partner
  int invented = 0;     ///< impacts of the tool that count, without a partner
  int late = 0;         ///< partners apart by more than 1 % of the mean time between impacts
  int wrong_speed = 0;  ///< partners, not late, whose speeds differ by more than 1 %
  /// Largest difference in time between partners, in mean times between impacts; of all partners
  /// until the first impact that is missed or invented. Nothing without partners.
  std::optional<double> time_error = {};
  std::optional<double> penetration = {};  ///< deepest [m]
  /// The kinetic energy with which the tool's impacts that count arrive, over that of the true
  /// ones, less 1: what its walls and integration have given (> 0) or taken in excess.
  std::optional<double> energy_gained = {};
  std::optional<double> seconds_per_impact = {};  ///< [s], over the true impacts that count

  int wrong() const { return missed + invented; }
};

Score score_of(const Answer& answer, const ScoredScene& scored);

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

/// For each true impact the place of its partner in the other list, or nothing. Both lists are in
/// order of time. Partners are on the same wall and at most `apart` [s] away from each other; on a
/// wall they keep their order, and nobody has two. Of all such pairings this one has the most
/// pairs, and of those the smallest sum of differences in time.
std::vector<std::optional<std::size_t>> partners_of(
    const std::vector<carrier_track::Impact>& true_ones,
    const std::vector<carrier_track::Impact>& found, double apart);

}  // namespace ricochet::studies::impact_test
