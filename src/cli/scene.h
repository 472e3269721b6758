#pragma once

#include "src/cli/scene_choice.h"

namespace ricochet::cli {

/// Prints the scene as a machine file; of a case of the paper, it says which numbers are fitted.
/// Returns the exit code.
int print_scene(const SceneChoice& choice);

}  // namespace ricochet::cli
