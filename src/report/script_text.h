#pragma once

#include <string>

#include "src/report/json.h"

namespace ricochet::report {

/// Returns the same JSON for a script of a page: "</script>" cannot occur in it.
std::string json_in_script(const std::string& json);

/// Returns a script element of this class that holds the data.
std::string data_script(const char* name, const Json& data);

}  // namespace ricochet::report
