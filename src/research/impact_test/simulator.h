#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "src/research/impact_test/answer.h"
#include "src/research/impact_test/scored_scene.h"
#include "src/research/impact_test/tool_program.h"

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

}  // namespace ricochet::studies::impact_test
