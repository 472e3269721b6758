#pragma once

#include <optional>
#include <string>

#include "problems/carrier_track/counting/feature_trace.h"
#include "problems/carrier_track/counting/neighbours.h"

/// Tests whether a count is certain. A scene's constants are known to a few digits only, and a
/// simulation rounds. So the scene is simulated again with all constants changed at once in their
/// tenth digit (perturbation.h), and the features of the motion (collisions.h) are compared one by
/// one. A count is certain if such a change makes no feature start or stop to count. A count is not
/// certain if infinitely many maxima count, if the change makes the walls cross, or if numbers
/// overflow.
namespace ricochet::carrier_track::inline counting {

/// Why a count is not certain: the first cause in time.
enum class Doubt {
  none,
  margin,     ///< the change moves a feature's margin z to or across zero
  window,     ///< the change moves a feature that counts to or across the end of the window
  graze,      ///< the change makes an impact or a maximum appear or vanish
  sensitive,  ///< the change grows more than 1e6-fold, or its simulation fails
  endless     ///< infinitely many maxima count, see FeatureTrace
};

struct Certainty {
  /// True if there is no doubt: every feature that counts has a counterpart in every changed scene,
  /// and each |margin| is larger than its change and than perturbation_size.
  bool certain = true;
  std::optional<double> margin;  ///< smallest |z| of all features; nothing without features
  std::optional<Graze> graze;    ///< the nearest in the window; nothing without a turning point
  /// Largest difference of a feature's scaled margin between a changed scene and the given one, in
  /// units of perturbation_size, of the features up to the first in doubt; 0 without features.
  double growth = 0;
  Doubt doubt = Doubt::none;
  std::string reason;  ///< the doubt as a sentence without a full stop; empty if certain
};

/// Returns the certainty of the count of a valid scene from its `trace` and `neighbours`. Simulates
/// the neighbours if they are needed and not simulated yet.
Certainty certainty_of(const Scene& scene, const FeatureTrace& trace, Neighbours& neighbours);

}  // namespace ricochet::carrier_track::inline counting
