#pragma once

#include <string>

namespace ricochet::cli {

/// Prints how far two stores or archives order their entries alike, by family.
int compare_stores(const std::string& first, const std::string& second, bool json);

}  // namespace ricochet::cli
