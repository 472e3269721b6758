#pragma once

#include <string>
#include <string_view>

#include "src/core/label.h"
#include "src/core/one_line.h"

namespace ricochet::exports {

/// Any text as a label of one line; see label() and one_line().
inline std::string label_of(std::string_view text) {
  return label(one_line(text));
}

}  // namespace ricochet::exports
