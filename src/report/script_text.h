#pragma once

#include <string>

namespace ricochet::report {

/// Returns the same JSON for a script of a page: "</script>" cannot occur in it.
std::string json_in_script(const std::string& json);

}  // namespace ricochet::report
