#pragma once

#include <string>

namespace ricochet::cli {

/// Throws InputError where an option's `file` would be written over `other`, which is `what`.
/// Either may be empty: then there is no such file.
void refuse_same_file(const char* option, const std::string& file, const std::string& other,
                      const char* what);

}  // namespace ricochet::cli
