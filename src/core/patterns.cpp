#include "src/core/patterns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>
#include <sstream>

#include "ricochet/error.h"
#include "src/core/near_names.h"

namespace ricochet {

bool fits(const std::string& name, const std::string& pattern) {
  return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

bool fits_any(const std::string& name, const std::vector<std::string>& patterns) {
  return std::any_of(patterns.begin(), patterns.end(),
                     [&](const std::string& pattern) { return fits(name, pattern); });
}

std::vector<std::string> split_patterns(const std::string& list) {
  std::vector<std::string> patterns;
  std::istringstream text(list);
  for (std::string pattern; std::getline(text, pattern, ',');) {
    if (!pattern.empty()) patterns.push_back(pattern);
  }
  return patterns;
}

void require_fit(const std::vector<std::string>& patterns, const std::vector<std::string>& names,
                 const std::string& place, const std::string& listing) {
  const bool any = std::any_of(names.begin(), names.end(),
                               [&](const std::string& name) { return fits_any(name, patterns); });
  if (any) return;
  const std::string wanted = fmt::format("{}", fmt::join(patterns, ","));
  throw InputError(fmt::format(
      "{} {}: nothing fits; {}", place, wanted,
      listing.empty() ? what_instead(wanted, names) : what_instead(wanted, names, listing)));
}

}  // namespace ricochet
