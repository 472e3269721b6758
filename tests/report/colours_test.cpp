#include <regex>

#include "src/report/painted.h"
#include "tests/report/pictures.h"
#include "tests/support/files.h"

namespace ricochet::report {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

/// Red, green and blue, linear, 0 to 1.
Vector3d linear(const std::string& colour) {
  Vector3d parts;
  for (int i = 0; i < 3; ++i) {
    const double part = std::stoi(colour.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
    parts[i] = part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
  }
  return parts;
}

/// Of sRGB, by the white D65 (CIE 15:2004).
Vector3d cielab(const Vector3d& rgb) {
  const Matrix3d to_xyz{{0.4124564, 0.3575761, 0.1804375},
                        {0.2126729, 0.7151522, 0.0721750},
                        {0.0193339, 0.1191920, 0.9503041}};
  Vector3d f = (to_xyz * rgb).cwiseQuotient(Vector3d(0.95047, 1.0, 1.08883));
  for (double& t : f) t = t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116;
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

double distance(const Vector3d& a, const Vector3d& b) {
  return (a - b).norm();
}

/// WCAG 2.2.
double contrast(const std::string& a, const std::string& b) {
  const auto luminance = [](const std::string& colour) {
    return linear(colour).dot(Vector3d(0.2126, 0.7152, 0.0722)) + 0.05;
  };
  const double ratio = luminance(a) / luminance(b);
  return std::max(ratio, 1 / ratio);
}

/// What dichromats see: Machado, Oliveira and Fernandes (2009), doi:10.1109/TVCG.2009.113,
/// severity 1.
const std::map<std::string, Matrix3d> visions = {
    {"normal", Matrix3d{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {"protanopia", Matrix3d{{0.152286, 1.052583, -0.204868},
                            {0.114503, 0.786281, 0.099216},
                            {-0.003882, -0.048116, 1.051998}}},
    {"deuteranopia", Matrix3d{{0.367322, 0.860646, -0.227968},
                              {0.280085, 0.672501, 0.047413},
                              {-0.011820, 0.042940, 0.968881}}},
    {"tritanopia", Matrix3d{{1.255528, -0.076749, -0.178779},
                            {-0.078411, 0.930809, 0.147602},
                            {0.004733, 0.691367, 0.303900}}}};

Vector3d seen(const std::string& colour, const Matrix3d& vision) {
  return cielab((vision * linear(colour)).cwiseMax(0).cwiseMin(1));
}

std::vector<std::string> series_colours() {
  Chart chart = line_chart({});
  chart.series.assign(7, {});
  std::vector<std::string> colours;
  for (std::size_t i = 0; i < 7; ++i) colours.push_back(look_of(chart, i).colour);
  return colours;
}

std::string template_text(const std::string& name) {
  return text_of(fs::path(RICOCHET_SOURCE) / "reports/templates" / name);
}

/// What the style makes of a colour of lines and of areas on a dark screen.
std::string in_the_dark(const std::string& colour, const std::string& attribute) {
  const std::regex rule("figure svg \\[" + attribute + "=\"" + colour + "\"\\] \\{ " + attribute +
                        ": (#[0-9a-f]{6})");
  const std::string sheet = template_text("look.css");
  std::smatch found;
  return std::regex_search(sheet, found, rule) ? found[1].str() : "none";
}

void expect_apart(const std::vector<std::string>& colours) {
  for (const auto& [name, vision] : visions) {
    for (std::size_t i = 0; i < colours.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const double apart = distance(seen(colours[i], vision), seen(colours[k], vision));
        EXPECT_GE(apart, 15) << colours[k] << " and " << colours[i] << ", " << name;
      }
    }
  }
}

TEST(Colours, OfSevenSeriesDifferForEveryReaderInTheLightAndInTheDark) {
  std::vector<std::string> dark;
  std::string list;
  for (const std::string& colour : series_colours()) {
    dark.push_back(in_the_dark(colour, "stroke"));
    EXPECT_EQ(in_the_dark(colour, "fill"), dark.back());
    list += (list.empty() ? "\"" : ", \"") + colour + "\"";
  }
  expect_apart(series_colours());
  ASSERT_THAT(dark, Each(StartsWith("#")));
  expect_apart(dark);
  EXPECT_THAT(template_text("charts.js"), HasSubstr("const colours = [" + list + "]"))
      << "charts by scripts have the same";
}

TEST(Colours, OfSeriesAndReferenceLinesStandOutFromThePaper) {
  const std::string sheet = template_text("look.css");
  std::smatch paper;
  ASSERT_TRUE(std::regex_search(sheet, paper, std::regex("dark\\)[^]*?--paper: (#[0-9a-f]{6})")));
  std::vector<std::string> colours = series_colours();
  for (const std::string& colour : colours)
    EXPECT_GE(contrast(in_the_dark(colour, "stroke"), paper[1]), 3) << colour;
  for (std::size_t i = 0; i < 3; ++i) colours.push_back(line_look(i).colour);
  for (const std::string& colour : colours) EXPECT_GE(contrast(colour, "#ffffff"), 3) << colour;
}

TEST(Colours, OfHeatMapsRiseInLightnessOrDivergeFromNearlyWhite) {
  double last = 0;
  for (int i = 0; i <= 100; ++i) {
    const double lightness = cielab(linear(palette_colour(i / 100.0)))[0];
    EXPECT_GT(lightness, last) << i;
    last = lightness;
  }
  const auto diverging = [](double share) { return cielab(linear(palette_colour(share, true))); };
  EXPECT_LT(distance(diverging(0.5), {97, 0, 0}), 1);
  // Steps of the same size, and the same lightness at the same distance from the middle.
  for (const double side : {-1, 1}) {
    const double mean = distance(diverging(0.5), diverging(0.5 + 0.5 * side)) / 10;
    for (int i = 0; i < 10; ++i) {
      const Vector3d from = diverging(0.5 + side * i / 20),
                     to = diverging(0.5 + side * (i + 1) / 20);
      EXPECT_NEAR(distance(from, to), mean, 0.15 * mean) << side * i;
      EXPECT_NEAR(to[0], diverging(0.5 - side * (i + 1) / 20)[0], 1) << side * i;
    }
  }
  for (const auto& [name, vision] : visions) {
    EXPECT_GT(
        distance(seen(palette_colour(0, true), vision), seen(palette_colour(1, true), vision)), 30)
        << name;
  }
}

TEST(Colours, OfCellsDivergeWhereValuesLieOnBothSidesOfZero) {
  const ReadSvg differences(to_svg(heat_map_chart({{-50, 0, 25}})));
  for (const double share : {0.0, 0.5, 0.75})
    EXPECT_EQ(differences.paths("fill", palette_colour(share, true)).size(), 1U) << share;
  const ReadSvg counts(to_svg(heat_map_chart({{0, 25, 50}})));
  EXPECT_EQ(counts.paths("fill", palette_colour(0.5)).size(), 1U);
}

TEST(Colours, OfTextsOnCellsCanBeRead) {
  for (const bool diverging : {false, true}) {
    for (int i = 0; i <= 100; ++i) {
      const std::string colour = palette_colour(i / 100.0, diverging);
      EXPECT_GE(contrast(text_colour(colour), colour), 4.5) << colour;
    }
  }
}

}  // namespace
}  // namespace ricochet::report
