#pragma once

#include <filesystem>
#include <vector>

#include "src/research/impact_test/scored_scene.h"

namespace ricochet::studies::impact_test {

/// The first `count` scenes of a seed, drawn on all cores and kept in the file: those that are
/// there, of this seed and version, are not drawn again. Shows progress.
std::vector<ScoredScene> scene_set(int seed, int count, const std::filesystem::path& file);

}  // namespace ricochet::studies::impact_test
