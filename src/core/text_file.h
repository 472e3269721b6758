#pragma once

#include <filesystem>
#include <string>

namespace ricochet {

/// Replaces the file by `text`, all or nothing: a reader never sees half of it. Throws InputError,
/// one line with path and reason, and leaves everything as it was, where that cannot be done.
void write_text_file(const std::filesystem::path& path, const std::string& text);

}  // namespace ricochet
