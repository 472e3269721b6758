#pragma once

#include <string>
#include <vector>

#include "src/research/impact_test/answer.h"
#include "src/research/impact_test/scored_scene.h"
#include "src/research/impact_test/tool.h"

namespace ricochet::studies::impact_test {

/// A level of ricochet's own model, measured like the tools, in this process.
struct OwnLevel {
  Tool tool;  ///< its name and what is said of it; nothing to run
  /// Simulates the machine of a scene, and times it.
  Answer (*answer)(const ScoredScene& scored, Level level);
};

/// Hard walls, by which the others are measured, first; then the same in a scan over speeds, hard
/// walls in two directions, and compliant walls by some laws.
const std::vector<OwnLevel>& own_levels();

/// The stiffness [N/m^1.5] of compliant walls at a level.
double stiffness_of(Level level);

/// The scene for fidelity planar: the same motion, with half of the friction from a wall in y
/// against which the body is pressed, or, where other forces act in y, without walls there.
Scene planar_machine(const Scene& machine);

}  // namespace ricochet::studies::impact_test
