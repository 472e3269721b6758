#pragma once

#include "src/report/json.h"

namespace ricochet::report {

/// Returns the data with every list of objects that have the same names in the same order as a
/// table, {"columns": [names], "rows": [[values], ...]}, at all depths. Throws std::logic_error if
/// the data have an object with exactly these two names.
Json packed(const Json& data);

/// Inverse of packed(). Anything that is not such a table is unchanged.
Json unpacked(Json data);

}  // namespace ricochet::report
