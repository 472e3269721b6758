#include "src/report/look.h"

#include <array>

namespace ricochet::report {

SeriesLook series_look(std::size_t n) {
  static constexpr std::array colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                      "#e69f00", "#56b4e9", "#555555"};
  static constexpr std::array dashes{"solid", "(10,4)", "(2,3)"};
  // Filled and open ones in turn, so that of two on one spot both are seen.
  static constexpr std::array markers{7, 4, 9, 12, 5, 6, 13, 8, 15, 14};
  return {colours[n % colours.size()], dashes[n % dashes.size()], markers[n % markers.size()]};
}

SeriesLook pale_look() {
  return {"#9a9a9a", "solid", 7};
}

LineLook line_look(std::size_t n) {
  static const std::array looks{LineLook{"#222222", "(7,4)", 1.4},
                                LineLook{"#f2b84b", "solid", 3.5},
                                LineLook{"#7b3294", "(1.5,3)", 2.0}};
  return looks[n % looks.size()];
}

// Even steps of lightness, so that it also reads in grey.
std::string palette() {
  return "(0 '#2b1c5e', 1 '#2f4f8f', 2 '#24808c', 3 '#3fae77', 4 '#a5cf4c', 5 '#f7e85c')";
}

std::string text_colour(double share) {
  return share < 0.5 ? "0xffffff" : "0x111111";
}

}  // namespace ricochet::report
