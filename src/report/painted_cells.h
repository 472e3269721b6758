#pragma once

#include "src/report/chart.h"
#include "src/report/drawing.h"
#include "src/report/frame.h"

namespace ricochet::report {

/// Paints the cells of a heat map, with their values if there is room, and the colour bar.
void paint_cells(const HeatMap& map, const Frame& frame, Drawing& drawing);

/// Paints the legend's sample for cells without a value; `from` is its left end, at half its
/// height.
void paint_key_of_gaps(const Pixel& from, Drawing& drawing);

}  // namespace ricochet::report
