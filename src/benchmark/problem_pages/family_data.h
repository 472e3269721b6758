#pragma once

#include "problems/family.h"
#include "src/report/json.h"

namespace ricochet::studies::problems {

/// What the page of a family with at least one question is drawn from.
report::Json family_data(const Family& family);

/// Its row in the table of all families.
report::Json family_row(const Family& family);

}  // namespace ricochet::studies::problems
