#pragma once

#include <cstddef>
#include <string>

#include "src/report/path_data.h"

namespace ricochet::report {

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

}  // namespace ricochet::report
