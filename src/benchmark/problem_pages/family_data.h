#pragma once

#include "ricochet/families.h"
#include "src/report/json.h"

namespace ricochet::studies::problems {

/// The data for the page of a family with at least one problem.
report::Json family_data(const Family& family);

/// The family's row in the table of all families.
report::Json family_row(const Family& family);

}  // namespace ricochet::studies::problems
