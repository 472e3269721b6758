#pragma once

#include <filesystem>

#include "src/report/site/study.h"

namespace ricochet::studies {

/// How close any interpretation of the paper can come to its claims: trade-offs, conflicts between
/// claims, and bounds. Resumes from the searches in fits.toml of the folder, which is the report's.
Study limits_study(const std::filesystem::path& folder);

}  // namespace ricochet::studies
