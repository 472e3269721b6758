#pragma once

#include "src/report/json.h"

namespace ricochet::site {

/// A number of the data to five digits, which is more than a front page shows; null where there is
/// none, or no finite one.
report::Json rounded(const report::Json& number);

}  // namespace ricochet::site
