#pragma once

#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/scene/scene.h"

namespace ricochet::carrier_track::inline paper {

/// The two speeds [rad/s] at which a figure of the paper shows x(t).
struct Figure {
  int number;
  double quiet, loud;
};

/// What the paper reports of a machine, section 3.3. Missing where it reports nothing.
struct Claim {
  std::optional<double> threshold;  ///< [rad/s]
  std::optional<int> quiet_count;   ///< the count that holds below the threshold
  std::optional<Figure> figure;
};

/// One combination of restitution, friction and disturbance that the paper studies.
struct Case {
  std::string id;
  double restitution;
  double friction;
  double disturbance;  ///< [N], amplitude of the cosine
  Claim claim;
};

/// C1..C12.
std::vector<Case> all_cases();

/// Throws InputError, with the ids there are, for an unknown id.
Case find_case(const std::string& id);

/// The scene of a case: the constants of a reading with the case's own.
Scene scene_of(const Case& a_case, const Scene& reading);

}  // namespace ricochet::carrier_track::inline paper
