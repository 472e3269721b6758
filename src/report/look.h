#pragma once

#include <cstddef>
#include <string>

namespace ricochet::report {

/// How the n-th series looks. Colours after Okabe and Ito (2008), which colour-blind readers tell
/// apart, without their yellow and black: too pale on white, and kept for text. Dashes and markers
/// repeat with periods that share no factor with the colours', so neither need be told alone.
struct SeriesLook {
  std::string colour;  ///< #rrggbb
  std::string dash;    ///< gnuplot's dash type
  int marker;          ///< gnuplot's point type
};
SeriesLook series_look(std::size_t n);

/// How what others are set against looks.
SeriesLook pale_look();

/// How the n-th label of reference lines looks: dark dashes over a broad pale line over dots, so
/// that lines that coincide all stay visible.
struct LineLook {
  std::string colour, dash;
  double width;  ///< pixels
};
LineLook line_look(std::size_t n);

/// The colours of a heat map, dark to light, as gnuplot's palette.
std::string palette();

/// The colour of text on the palette's colour at the share in [0, 1].
std::string text_colour(double share);

}  // namespace ricochet::report
