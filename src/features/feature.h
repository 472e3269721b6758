#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "src/core/problem.h"

namespace ricochet {

/// Something that makes a problem harder to solve without changing what is asked: what the solver
/// sees is perturbed, what it is judged by is not. Where coordinates change, box, start and best
/// point change with them.
struct Feature {
  std::string name;     ///< e.g. "noisy"
  std::string summary;  ///< what it does, in one line, with its constants
  /// Whether the problem can be perturbed so.
  std::function<bool(const Problem&)> applies;
  /// The perturbed problem, of the same name, for ONE run with this seed: what is drawn anew at
  /// every call is counted within it, so it is to be made for every run, and called by one thread.
  std::function<Problem(const Problem& shown, std::uint64_t seed)> perturbed;
};

/// "plain" first, which changes nothing.
const std::vector<Feature>& all_features();

/// How a run shows its problem: the name of the form and, unless it is "plain", of the feature. It
/// goes into the run's seed: see seed_of.
std::string shown_as(const std::string& form, const std::string& feature);

}  // namespace ricochet
