#pragma once

#include <string>

#include "src/report/json.h"

namespace ricochet::cli {

/// Returns the manual page of the commands of the description, as roff.
std::string manual(const report::Json& commands);

}  // namespace ricochet::cli
