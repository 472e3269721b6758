#pragma once

#include <filesystem>

#include "src/studies/study.h"

namespace ricochet::studies {

/// Readings of the paper that none of the reproduction's questions has: simulated with something
/// changed, fitted as long as what they change, and judged alike. Goes on from the fits that
/// fits.toml of the folder holds.
Study trials_study(const std::filesystem::path& folder);

}  // namespace ricochet::studies
