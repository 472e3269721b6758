#pragma once

#include <string>

namespace ricochet::cli {

/// Throws InputError if an option's `file` would overwrite `other`, described by `what`. An empty
/// name means no file.
void refuse_same_file(const char* option, const std::string& file, const std::string& other,
                      const char* what);

}  // namespace ricochet::cli
