#pragma once

#include <string>
#include <vector>

/// Names chosen by patterns, as a shell chooses files (fnmatch).
namespace ricochet {

bool fits(const std::string& name, const std::string& pattern);

bool fits_any(const std::string& name, const std::vector<std::string>& patterns);

/// The patterns of a comma-separated list.
std::vector<std::string> split_patterns(const std::string& list);

/// Throws InputError if no name matches any of the patterns: "`place` <patterns>: nothing fits",
/// with similar names, or else with `listing`, where they are listed, or else with all names.
void require_fit(const std::vector<std::string>& patterns, const std::vector<std::string>& names,
                 const std::string& place, const std::string& listing = "");

}  // namespace ricochet
