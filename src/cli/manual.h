#pragma once

#include <string>

#include "src/report/json.h"

namespace ricochet::cli {

/// The manual page of the commands of the description, in the language of man.
std::string manual(const report::Json& commands);

}  // namespace ricochet::cli
