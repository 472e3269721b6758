#pragma once

#include <string>

#include "src/report/json.h"

namespace ricochet::cli {

/// Returns the text under a key in a description of the commands (CommandLine::description).
inline std::string text_of(const report::Json& object, const char* key) {
  return object.at(key).get<std::string>();
}

}  // namespace ricochet::cli
