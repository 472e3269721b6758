#pragma once

#include <vector>

#include "src/report/site/own_page.h"

namespace ricochet::site {

/// The page that says how to cite ricochet and how to repeat its reports: BibTeX, versions, seeds,
/// plan, digest, archive and commands. `comparison`: the one whose runs are described, or null.
OwnPage cite_page(const std::vector<FoundReport>& reports, const FoundReport* comparison);

}  // namespace ricochet::site
