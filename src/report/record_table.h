#pragma once

#include "src/report/json.h"

namespace ricochet::report {

/// The data with every list of objects that have the same names in the same order as a table,
/// {"columns": [names], "rows": [[values], ...]}, at all depths: no name is written twice. Throws
/// std::logic_error where the data have an object of just these two names.
Json packed(const Json& data);

/// The data as they were before. What is no such table stays as it is.
Json unpacked(Json data);

}  // namespace ricochet::report
