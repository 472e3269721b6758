#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "ricochet/error.h"
#include "src/core/near_names.h"

namespace ricochet::cli {

/// Returns the element of that name. Throws InputError, which says `what` it should be, if there is
/// none.
template <class List, class NameOf>
auto named(const List& list, const std::string& wanted, const std::string& what, NameOf name_of) {
  std::vector<std::string> known;
  for (const auto& entry : list) {
    if (name_of(entry) == wanted) return entry;
    known.push_back(name_of(entry));
  }
  throw InputError(
      fmt::format("{}: there is no such {}; {}", wanted, what, what_instead(wanted, known)));
}

}  // namespace ricochet::cli
