#pragma once

#include <string>

namespace ricochet::cli {

/// Draws a report, or all reports of a folder, again from their data into `out`; empty: where they
/// are. Throws InputError, which names file and place, for data that are none of a report's or of
/// which a chart cannot be drawn; then everything else has been drawn.
int draw_again(const std::string& from, const std::string& out);

}  // namespace ricochet::cli
