#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "src/report/chart.h"
#include "src/report/drawing.h"
#include "src/report/frame.h"
#include "src/report/svg.h"

namespace ricochet::report {

/// Paints the areas of a chart, within its clipping region.
void paint_areas(const Chart& chart, const Frame& frame, const std::string& clip, Drawing& drawing);

/// Writes the name of each area into it, where it has most room, if it has any.
void write_names_of_areas(const Chart& chart, const Frame& frame, Drawing& drawing);

/// Paints the legend's sample of an area; `from` is its left end, at half its height.
void paint_key_of(const Area& area, const Pixel& from, Drawing& drawing);

/// Paints the cells of a heat map, with their values if there is room, and the colour bar.
void paint_cells(const HeatMap& map, const Frame& frame, Drawing& drawing);

/// Paints the legend's sample for cells without a value; `from` is its left end, at half its
/// height.
void paint_key_of_gaps(const Pixel& from, Drawing& drawing);

/// The shape of a point: a circle, or a polygon whose first corner points up.
struct Marker {
  int corners;  ///< 0: a circle
  bool filled;
};

/// Style of a series. Any two of the seven colours differ by at least 15 in CIELAB for readers with
/// normal vision, protanopia, deuteranopia and tritanopia, and each has a contrast of at least 3 to
/// white; in the dark reports/templates/look.css replaces them. The periods of dashes and markers
/// share no factor with that of the colours, so that either alone identifies a series.
struct SeriesLook {
  std::string colour;  ///< #rrggbb
  std::string dash;    ///< SVG's stroke-dasharray; empty: solid
  Marker marker;
};

/// Style of a series of the chart: pale ones do not count, dark ones have dashes and markers alone.
SeriesLook look_of(const Chart& chart, std::size_t series);

/// A marker of a radius around a place, both in pixels.
Outline outline_of(const Marker& marker, const Pixel& place, double radius);

/// Style of the n-th label of reference lines: dark dashes over a broad line over dots, so that
/// coinciding lines all stay visible.
struct LineLook {
  std::string colour, dash;
  std::string width;  ///< pixels
};
LineLook line_look(std::size_t n);

/// Returns the colour of a heat map at a share in [0, 1], in 100 steps: from dark to light, or, if
/// the colours diverge, from blue over nearly white at 0.5 to vermillion.
std::string palette_colour(double share, bool diverging = false);

/// The colour of text on a colour, #rrggbb: black or white, with a contrast of at least 4.5.
std::string text_colour(const std::string& colour);

/// Returns the indices of the corners that suffice to draw a line (Douglas and Peucker,
/// Cartographica 10 (1973) 112): the other corners lie at most `tolerance` from it. Both ends are
/// kept.
std::vector<std::size_t> needed_corners(const std::vector<Pixel>& line, double tolerance);

/// Returns the samples that suffice to draw a line through all, with at most an error of `across`
/// in position and `up` in value, both > 0. Every sample must have a value.
std::vector<Sample> simplified(const std::vector<Sample>& samples, double across, double up);

}  // namespace ricochet::report
