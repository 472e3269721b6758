#pragma once

#include <functional>
#include <optional>
#include <string>

#include "src/research/impact_test/scored_scene.h"

namespace ricochet::studies::impact_test {

/// A simpler scene that still breaks a tool, as found by dropping forces, friction and walls, by
/// cutting the window and rounding numbers, one step at a time, as long as `breaks` says that the
/// scene still does. Each step must leave a scene that is well conditioned up to its end. At most
/// `most_asks` scenes are tried.
ScoredScene smallest_scene(const ScoredScene& broken,
                           const std::function<bool(const ScoredScene&)>& breaks, int most_asks);

/// The scene of a machine as it is, with its truth: its window and counting limit stay. Nothing if
/// it is not a valid machine, has no impact that counts, or is not well conditioned up to its end.
std::optional<ScoredScene> exactly(const Scene& machine);

/// The machine in a line: the fields that are not at their default, with units.
std::string words_of(const Scene& machine);

}  // namespace ricochet::studies::impact_test
