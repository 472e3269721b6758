#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "ricochet/problem.h"

namespace ricochet {

/// Makes a problem harder to solve without changing the problem itself: the solver sees perturbed
/// values, but is scored on the true objective. If coordinates change, box, start and best point
/// change with them.
struct Perturbation {
  std::string name;     ///< e.g. "noisy"
  std::string summary;  ///< its effect, in one line, with its constants
  /// Returns true if the problem can be perturbed this way.
  std::function<bool(const Problem&)> applies;
  /// The perturbed problem, of the same name, for ONE run with this seed. It counts its calls to
  /// draw independent numbers at each, so make one for every run, and use it in one thread.
  std::function<Problem(const Problem& shown, std::uint64_t seed)> perturbed;
};

/// All perturbations, first "plain", which changes nothing.
const std::vector<Perturbation>& all_perturbations();

/// The name for how a run shows its problem: that of the formulation and, unless it is "plain",
/// that of the perturbation. It enters the run's seed: see seed_of.
std::string shown_as(const std::string& formulation, const std::string& perturbation);

}  // namespace ricochet
