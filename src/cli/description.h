#pragma once

#include <string>

#include "src/report/json.h"

namespace ricochet::cli {

/// What a description of the commands (CommandLine::description) says under a key.
inline std::string text_of(const report::Json& object, const char* key) {
  return object.at(key).get<std::string>();
}

}  // namespace ricochet::cli
