#pragma once

#include <string>

namespace ricochet::cli {

/// Writes the site of a folder of reports into `out`, ready for a static host, and prints its size.
/// Throws InputError as publish_site does, and for data of which something cannot be drawn; then
/// everything else has been drawn.
int write_site(const std::string& from, const std::string& out);

}  // namespace ricochet::cli
