#pragma once

#include <filesystem>
#include <vector>

#include "src/benchmark/analysis/rated_family.h"

namespace ricochet::exports {

/// Writes summary.tex, a table that fits a page: the first ranked entries of each family, as many
/// of each as 45 rows allow, but at least one, and none that solved no run. Names that are too long
/// for the page make the table smaller. A comment lists the LaTeX packages it needs.
void write_latex_summary(const std::vector<comparison::RatedFamily>& families,
                         const std::filesystem::path& folder);

}  // namespace ricochet::exports
