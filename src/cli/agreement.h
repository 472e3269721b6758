#pragma once

#include <string>

namespace ricochet::cli {

/// Prints how far two stores or archives order their entries alike, by family, and which entries
/// changed from the first to the second: see entry_changes().
int compare_stores(const std::string& first, const std::string& second, bool json);

}  // namespace ricochet::cli
