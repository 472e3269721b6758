#pragma once

#include "src/report/json.h"

namespace ricochet::studies::comparison {

/// Splits all results into the data of a comparison's report: the page with the answers, and under
/// `pages` one for each family, one across machines and one of failures, if there are any.
report::Json in_pages(report::Json all);

}  // namespace ricochet::studies::comparison
