#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "ricochet/error.h"
#include "src/core/near_names.h"

namespace ricochet::cli {

/// Returns the element of that name, in any letter case if only one fits. Throws InputError, which
/// says `what` it should be, if there is none; `listing` is the command that lists the names, if
/// they are too many to print.
template <class List, class NameOf>
auto named(const List& list, const std::string& wanted, const std::string& what, NameOf name_of,
           const std::string& listing = "") {
  std::vector<std::string> known;
  for (const auto& entry : list) known.push_back(name_of(entry));
  const std::string* name = match(wanted, known);
  for (const auto& entry : list) {
    if (name != nullptr && name_of(entry) == *name) return entry;
  }
  throw InputError(fmt::format(
      "{}: there is no such {}; {}", wanted, what,
      listing.empty() ? what_instead(wanted, known) : what_instead(wanted, known, listing)));
}

}  // namespace ricochet::cli
