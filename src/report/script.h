#pragma once

#include <string>

#include "src/report/chart.h"

namespace ricochet::report {

/// The chart as a gnuplot script with its data inside. The chart must have passed its check.
std::string gnuplot_script(const Chart& chart);

/// The names under which the script's fonts go; they are for the SVG to replace.
inline constexpr const char* body_font = "Body";
inline constexpr const char* title_font = "Title";

}  // namespace ricochet::report
