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

/// Style of the n-th series. Colours after Okabe and Ito (2008), distinguishable by colour-blind
/// readers, without their yellow (too pale on white) and black (used for text). The periods of
/// dashes and markers share no factor with that of the colours, so that either alone identifies a
/// series.
struct SeriesLook {
  std::string colour;  ///< #rrggbb
  std::string dash;    ///< SVG's stroke-dasharray; empty: solid
  Marker marker;
};
SeriesLook series_look(std::size_t n);

/// Style of the n-th series if it is dark: its dashes.
SeriesLook dark_look(std::size_t n);

/// Style of a series in the background.
SeriesLook pale_look();

/// A marker of a radius around a place, both in pixels.
Outline outline_of(const Marker& marker, const Pixel& place, double radius);

/// Style of the n-th label of reference lines: dark dashes over a broad pale line over dots, so
/// that coinciding lines all stay visible.
struct LineLook {
  std::string colour, dash;
  std::string width;  ///< pixels
};
LineLook line_look(std::size_t n);

/// Returns the colour of a heat map at a share in [0, 1], from dark to light, in 100 steps.
std::string palette_colour(double share);

/// The colour of text on the palette's colour at the share in [0, 1].
std::string text_colour(double share);

/// Returns the indices of the corners that suffice to draw a line (Douglas and Peucker,
/// Cartographica 10 (1973) 112): the other corners lie at most `tolerance` from it. Both ends are
/// kept.
std::vector<std::size_t> needed_corners(const std::vector<Pixel>& line, double tolerance);

/// Returns the samples that suffice to draw a line through all, with at most an error of `across`
/// in position and `up` in value, both > 0. Every sample must have a value.
std::vector<Sample> simplified(const std::vector<Sample>& samples, double across, double up);

}  // namespace ricochet::report
