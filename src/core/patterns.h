#pragma once

#include <string>
#include <vector>

/// Names chosen by patterns, as a shell chooses files (fnmatch).
namespace ricochet {

bool fits(const std::string& name, const std::string& pattern);

bool fits_any(const std::string& name, const std::vector<std::string>& patterns);

/// The patterns of a list with commas between.
std::vector<std::string> split_patterns(const std::string& list);

/// Throws InputError where none of the names fits any of the patterns: "`place` <patterns>: nothing
/// fits", and what may have been meant.
void require_fit(const std::vector<std::string>& patterns, const std::vector<std::string>& names,
                 const std::string& place);

}  // namespace ricochet
