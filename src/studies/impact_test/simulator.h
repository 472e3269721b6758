#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "src/studies/impact_test/smallest_scene.h"
#include "src/studies/impact_test/test_scene.h"
#include "src/studies/impact_test/tool.h"

namespace ricochet::studies::impact_test {

/// Asks for the answer to a scene. Throws ToolFailure if there will be none to any scene.
using Ask = std::function<Answer(const ScoredScene&)>;

/// Whatever is tested: a tool, or a level of ricochet's own model.
struct Simulator {
  Tool tool;
  std::string version;
  bool own = false;
  std::function<Ask(Level)> open;  ///< for this thread alone
};

/// The levels of ricochet's own model, ricochet itself first.
std::vector<Simulator> own_simulators();

/// A tool whose errors are written to files in the folder `logs`.
Simulator simulator_of(const ToolProgram& program, const std::filesystem::path& logs);

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
