#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <cstdlib>

#include "src/report/svg.h"

namespace ricochet::report {
namespace {

TEST(PathData, GoesFromCornerToCorner) {
  EXPECT_EQ(path_data({{{{60.2, 218.34}, {60.2, 54}}}, {{{70, 54}, {80, 54}, {79.5, 60}}}}),
            "M60.2 218.3v-164.3m9.8 0h10l-.5 6");
  EXPECT_EQ(path_data({{{{1, 1}, {3, 1}, {3, 2}}, true}, {{{1.5, 1}, {2, 1.5}}}}),
            "M1 1h2v1zm.5 0l.5.5");
}

/// Where the data of one open line end.
Pixel end_of(const std::string& data) {
  Pixel place{0, 0};
  char command = 'M';
  const char* at = data.c_str();
  const auto number = [&at] {
    char* end = nullptr;
    const double value = std::strtod(at, &end);
    at = end;
    return value;
  };
  while (*at != '\0') {
    if (std::isalpha(*at) != 0) command = *at++;
    if (command != 'v') place.x += number();
    if (command != 'h') place.y += number();
  }
  return place;
}

TEST(PathData, EndsWhereTheLineDoesHoweverManyStepsThereAre) {
  Outline spiral;
  for (int i = 0; i <= 2000; ++i) {
    const double turn = i / 100.0;
    spiral.corners.push_back({200 + 9 * turn * std::cos(turn), 200 + 9 * turn * std::sin(turn)});
  }
  const std::string data = path_data({spiral});
  EXPECT_LT(data.size(), 5000U);
  EXPECT_NEAR(end_of(data).x, spiral.corners.back().x, 0.051);
  EXPECT_NEAR(end_of(data).y, spiral.corners.back().y, 0.051);
}

TEST(PathData, MakesADotOfOneCornerAndArcsOfACircle) {
  EXPECT_EQ(path_data({{{{3, 4}}}, {{{5, 4}}}}), "M3 4h0m2 0h0");
  EXPECT_EQ(path_data({{{{3, 4}}, true, 2}, {{{4, 4}, {4, 5}}}}),
            "M3 4m-2 0a2 2 0 1 0 4 0 2 2 0 1 0-4 0zm3 0v1");
}

TEST(PathData, DrawsOnceWhatLiesOnEachOther) {
  EXPECT_EQ(path_data({{{{3, 4}}}, {{{3.04, 3.96}}}, {{{3.1, 4}}}}), "M3 4h0m.1 0h0");
  const Outline box{{{0, 0}, {4, 0}, {4, 4}}, true};
  EXPECT_EQ(path_data({box, box}), path_data({box}));
}

TEST(PathData, IsEmptyForNothing) {
  EXPECT_EQ(path_data({}), "");
}

}  // namespace
}  // namespace ricochet::report
