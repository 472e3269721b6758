#pragma once

#include <string>

#include "src/cli/format.h"

namespace ricochet::cli {

/// The manual page of the commands of the description, in the language of man.
std::string manual(const Json& commands);

}  // namespace ricochet::cli
