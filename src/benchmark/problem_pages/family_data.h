#pragma once

#include "ricochet/families.h"
#include "src/report/json.h"

namespace ricochet::studies::problems {

/// The data for the page of a family with at least one problem. How hard each problem is rests on
/// this many simulations at least, >= 1.
report::Json family_data(const Family& family, int simulations);

/// The family's row in the table of all families.
report::Json family_row(const Family& family);

}  // namespace ricochet::studies::problems
