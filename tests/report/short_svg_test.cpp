#include "src/report/short_svg.h"

#include <gmock/gmock.h>

namespace ricochet::report {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string written(const Picture& picture) {
  return short_svg(picture, "name", "a < b", "c & d");
}

TEST(ShortSvg, SaysWhatItIs) {
  Picture picture;
  picture.width = 400;
  picture.height = 300;
  EXPECT_EQ(
      written(picture),
      "<svg class=\"ricochet-chart\" width=\"400\" height=\"300\" viewBox=\"0 0 400 300\" "
      "xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" "
      "aria-labelledby=\"name-title name-desc\" font-family=\"system-ui, sans-serif\" "
      "font-size=\"12\">\n"
      "<title id=\"name-title\">a &lt; b</title>\n"
      "<desc id=\"name-desc\">c &amp; d</desc>\n"
      "<rect width=\"400\" height=\"300\" fill=\"#ffffff\" />\n<g fill=\"none\" />\n</svg>\n");
}

TEST(ShortSvg, PaintsWithOneBrushInOnePath) {
  Picture picture;
  picture.layers = {
      {{{.stroke = "#888888", .width = "0.7"}, {{{{1, 1}, {2, 1}}}, {{{1, 3}, {2, 3}}}}}},
      {{{.fill = "#ff0000", .crisp = true},
        {{{{0, 5}, {5, 5}, {5, 0}, {0, 0}}, true}, {{{5, 5}, {10, 5}, {10, 0}, {5, 0}}, true}}}}};
  const std::string svg = written(picture);
  EXPECT_THAT(svg,
              HasSubstr("<path stroke=\"#888888\" stroke-width=\"0.7\" d=\"M1 1h1m-1 2h1\" />"));
  EXPECT_THAT(svg, HasSubstr("<g shape-rendering=\"crispEdges\">\n"
                             "<path fill=\"#ff0000\" d=\"M0 5h10v-5h-10z\" />\n</g>"));
}

TEST(ShortSvg, WritesTextsOfOneStyleTogether) {
  Picture picture;
  const auto tick = [](double x, const char* text) {
    return Writing{
        .fill = "#444444", .size = "12", .anchor = "middle", .place = {x, 9.6}, .text = text};
  };
  picture.writings = {tick(1, "0"),
                      {.fill = "black",
                       .size = "14",
                       .anchor = "start",
                       .weight = "Title",
                       .place = {8.3, 27.9},
                       .text = "title"},
                      tick(10.4, "5")};
  const std::string svg = written(picture);
  EXPECT_THAT(svg,
              HasSubstr("<g fill=\"#444444\" text-anchor=\"middle\">\n"
                        "<text x=\"1\" y=\"10\">0</text>\n<text x=\"10\" y=\"10\">5</text>\n</g>"));
  EXPECT_THAT(svg, HasSubstr("<text fill=\"black\" font-size=\"14\" font-weight=\"600\" x=\"8\" "
                             "y=\"28\">title</text>"));
  picture.writings = {{.fill = "black", .turned = "rotate(270)", .place = {19, 20}, .text = "up"}};
  EXPECT_THAT(written(picture), HasSubstr("transform=\"translate(19,20)rotate(270)\">up<"));
}

TEST(ShortSvg, MakesTheBarAGradientOfItsName) {
  Picture picture;
  picture.bar =
      ColourBar{{{{0, 9}, {3, 9}, {3, 0}, {0, 0}}, true}, {"#000000", "#777777", "#ffffff"}};
  const std::string svg = written(picture);
  EXPECT_THAT(svg,
              HasSubstr("<linearGradient id=\"name-bar\" x1=\"0\" x2=\"0\" y2=\"0\" y1=\"1\">"));
  EXPECT_THAT(svg, HasSubstr("<stop offset=\"0.5\" stop-color=\"#777777\" />"));
  EXPECT_THAT(svg, HasSubstr("<path fill=\"url(#name-bar)\" d=\"M0 9h3v-9h-3z\" />"));
  EXPECT_THAT(svg, Not(HasSubstr("pattern")));
}

TEST(ShortSvg, KeepsOnePatternOfThoseThatAreAlike) {
  pugi::xml_document document;
  document.load_string(
      "<defs><pattern id='p1'><path d='M0,0'/></pattern>"
      "<pattern id='p2'><path d='M0,0'/></pattern></defs>");
  Picture picture;
  for (pugi::xml_node pattern : document.child("defs").children()) {
    const std::string use = std::string("url(#") + pattern.attribute("id").value() + ")";
    picture.patterns[use] = pattern;
    picture.layers.push_back({{{.fill = use}, {{{{0, 5}, {5, 5}, {5, 0}, {0, 0}}, true}}}});
  }
  const std::string svg = written(picture);
  EXPECT_THAT(svg, HasSubstr("<pattern id=\"name-p1\">"));
  EXPECT_THAT(svg, Not(HasSubstr("p2")));
}

}  // namespace
}  // namespace ricochet::report
