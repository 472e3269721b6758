#pragma once

#include <string>
#include <string_view>

/// Compression to the .xz format (https://tukaani.org/xz/xz-file-format.txt), by liblzma.
namespace ricochet {

/// Whether these bytes begin as an .xz file does.
bool is_xz(std::string_view bytes);

/// The bytes as an .xz file, as small as liblzma makes it: takes some 700 MB of memory, and a
/// second for each MB.
std::string xz_compressed(std::string_view bytes);

/// What such a file holds. Throws InputError if it is damaged, cut off, or holds more than `most`
/// bytes.
std::string xz_decompressed(std::string_view file, std::size_t most);

}  // namespace ricochet
