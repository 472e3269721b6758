#pragma once

#include <filesystem>

#include "src/studies/study.h"

namespace ricochet::studies {

/// How near any reading of the paper can come to its claims: what can be had together, which claim
/// excludes which, and bounds. Goes on from the searches that fits.toml of the folder, which is the
/// report's, holds.
Study limits_study(const std::filesystem::path& folder);

}  // namespace ricochet::studies
