#pragma once

#include <string>

#include "src/report/chart.h"
#include "src/report/drawing.h"
#include "src/report/frame.h"

namespace ricochet::report {

/// Paints the areas of a chart, within its clipping region.
void paint_areas(const Chart& chart, const Frame& frame, const std::string& clip, Drawing& drawing);

/// Writes the name of each area into it, where it has most room, if it has any.
void write_names_of_areas(const Chart& chart, const Frame& frame, Drawing& drawing);

/// Paints the legend's sample of an area; `from` is its left end, at half its height.
void paint_key_of(const Area& area, const Pixel& from, Drawing& drawing);

}  // namespace ricochet::report
