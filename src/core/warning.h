#pragma once

#include <string>

namespace ricochet {

/// Writes "warning: TEXT" as a line to standard error, only once for each text. May be called from
/// several threads at once.
void warn(const std::string& text);

}  // namespace ricochet
