#pragma once

#include "src/report/json.h"

namespace ricochet::studies::contest {

/// What a contest's report is drawn from, out of all that was found: the page with the answers, and
/// under `pages` one for each family, one across machines and one of failures, where there is any.
report::Json in_pages(report::Json all);

}  // namespace ricochet::studies::contest
