#pragma once

#include <string>
#include <vector>

#include "src/experiment/campaign.h"

namespace ricochet::cli {

/// The file of an archive: that of the reference's runs, which is included, for the name "archive".
std::string archive_named(const std::string& name);

/// The plan that compares the user's solvers with those of an archive. If `out` has no store yet,
/// makes it, with the archive's runs. Writes to standard error which solvers of the archive this
/// build lacks, or has in another version.
Plan plan_against_archive(const std::string& archive, const std::vector<std::string>& own_solvers,
                          const Catalogue& catalogue, const std::string& out);

}  // namespace ricochet::cli
