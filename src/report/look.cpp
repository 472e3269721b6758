#include "src/report/look.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ricochet::report {

SeriesLook series_look(std::size_t n) {
  static constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                      "#e69f00", "#56b4e9", "#555555"};
  static constexpr std::array dashes{"", "8.5,3.4", "1.7,2.5"};
  // Filled and open markers alternate, so that both are visible if two coincide.
  static constexpr std::array markers{
      Marker{0, true},  Marker{4, false}, Marker{3, true},  Marker{5, false}, Marker{4, true},
      Marker{0, false}, Marker{6, true},  Marker{3, false}, Marker{5, true},  Marker{6, false}};
  return {colours[n % colours.size()], dashes[n % dashes.size()], markers[n % markers.size()]};
}

SeriesLook dark_look(std::size_t n) {
  SeriesLook look = series_look(n);
  look.colour = "#1a1a1a";
  return look;
}

SeriesLook pale_look() {
  return {"#9a9a9a", "", {0, true}};
}

Outline outline_of(const Marker& marker, const Pixel& place, double radius) {
  if (marker.corners == 0) return {{place}, true, radius};
  Outline outline{{}, true};
  const double size = 1.25 * radius;  // about the same area as the circle
  for (int i = 0; i < marker.corners; ++i) {
    const double turn = 2 * std::numbers::pi * i / marker.corners;
    outline.corners.push_back({place.x + size * std::sin(turn), place.y - size * std::cos(turn)});
  }
  return outline;
}

LineLook line_look(std::size_t n) {
  static const std::array looks{LineLook{"#222222", "4.9,2.8", "1.4"},
                                LineLook{"#f2b84b", "", "3.5"}, LineLook{"#7b3294", "1.5,3", "2"}};
  return looks[n % looks.size()];
}

std::string palette_colour(double share) {
  // Even steps of lightness, so that it also reads in grey.
  static constexpr std::array<std::array<int, 3>, 6> colours{{{0x2b, 0x1c, 0x5e},
                                                              {0x2f, 0x4f, 0x8f},
                                                              {0x24, 0x80, 0x8c},
                                                              {0x3f, 0xae, 0x77},
                                                              {0xa5, 0xcf, 0x4c},
                                                              {0xf7, 0xe8, 0x5c}}};
  const auto step = static_cast<int>(std::lround(100 * std::clamp(share, 0.0, 1.0)));
  const auto below = static_cast<std::size_t>(std::min(step / 20, 4));
  const int above_it = step - 20 * static_cast<int>(below);
  std::string text = "#";
  for (std::size_t i = 0; i < 3; ++i) {
    const int from = colours[below][i], to = colours[below + 1][i];
    text += fmt::format("{:02x}", from + (to - from) * above_it / 20);
  }
  return text;
}

std::string text_colour(double share) {
  return share < 0.5 ? "#ffffff" : "#111111";
}

}  // namespace ricochet::report
