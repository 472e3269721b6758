#pragma once

#include <functional>
#include <optional>
#include <string>

#include "src/studies/impact_test/test_scene.h"

namespace ricochet::studies::impact_test {

/// A scene of the test, with what it is scored by.
struct ScoredScene {
  int seed = 0;  ///< of the draw
  TestScene scene;
  Scene machine;  ///< the same for ricochet; its counting limit is the scene's `slowest`
  Truth truth;
};

/// Scene `index` >= 0 of a seed; each can be drawn alone. Kinds alternate, and then difficulties.
/// A scene is drawn again until it has a truth and at least one scored impact. Its window ends in a
/// gap between impacts, before it is badly conditioned.
ScoredScene drawn_scene(int seed, int index);

/// The scene of a machine, with its truth; `slowest_share` as in DrawnScene. Nothing if there is
/// none.
std::optional<ScoredScene> scored_scene(Scene machine, double slowest_share, Random& random);

/// No scored impact is slower [m/s]: tools may set a body to rest at 1e-6 m/s.
inline constexpr double least_slowest = 1e-5;

/// A window ends at least so far from an impact, in mean times between impacts.
inline constexpr double clear_of_the_end = 0.1;

/// A window ends after so many scored impacts.
inline constexpr int most_impacts = 200;

/// A line of scenes.jsonl: the scene as a tool reads it, then `impacts`, the truth, and `machine`,
/// the scene as a machine file.
report::Json json_of(const ScoredScene& scored);
/// Throws Json::exception or InputError for another.
ScoredScene scored_scene_of(const report::Json& line);

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
