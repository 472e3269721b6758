#pragma once

#include <vector>

#include "src/report/json.h"
#include "src/report/page.h"

namespace ricochet::site {

/// The charts of a front page for paper and for those who run no script, of the same rows as those
/// that move: speed against accuracy of each family with its largest budget, how a motion is
/// computed, and both at once. A chart that would be empty is left out.
std::vector<report::Chart> front_charts(const report::Json& data);

}  // namespace ricochet::site
