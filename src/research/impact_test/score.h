#pragma once

#include <optional>

#include "src/research/impact_test/answer.h"
#include "src/research/impact_test/scored_scene.h"

namespace ricochet::studies::impact_test {

/// An answer compared with the truth. An impact counts if it is faster than the scene's `slowest`.
/// A partner (match.h) is at most half a mean time between impacts away, and needs only half that
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

}  // namespace ricochet::studies::impact_test
