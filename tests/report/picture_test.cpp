#include "src/report/picture.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace ricochet::report {
namespace {

class PictureTest : public testing::Test {
 protected:
  Picture shown(const std::string& inside) {
    document_.load_string(
        ("<svg width='400' height='300'><g id='gnuplot_canvas'>" + inside + "</g></svg>").c_str());
    return picture_of(document_);
  }

 private:
  pugi::xml_document document_;
};

TEST_F(PictureTest, HasALayerForTheAxesAndOneForEachPlot) {
  const Picture picture = shown(
      "<g color='black' stroke='currentColor' stroke-width='1.00'>"
      "<path stroke='rgb(136,136,136)' d='M1.00,2.00 L3.00,2.00 M5.00,5.00 '/></g>"
      "<g id='gnuplot_plot_1'><g color='black' stroke='currentColor' stroke-width='1.70'>"
      "<path stroke='rgb(  0, 114, 178)' stroke-dasharray='5.0,2.0' d='M0.00,0.00 L4.00,4.00'/>"
      "</g></g>"
      "<g color='black' stroke='currentColor' stroke-width='1.00'>"
      "<path stroke='rgb(136,136,136)' d='M1.00,2.00 L3.00,2.00'/></g>");
  EXPECT_EQ(picture.width, 400);
  EXPECT_EQ(picture.height, 300);
  ASSERT_EQ(picture.layers.size(), 2U);
  // The line that is drawn twice is there once, and a move without a line is none.
  EXPECT_EQ(picture.layers[0], (Layer{{{.stroke = "#888888"}, {{{{1, 2}, {3, 2}}}}}}));
  EXPECT_EQ(
      picture.layers[1],
      (Layer{{{.stroke = "#0072b2", .width = "1.7", .dash = "5.0,2.0"}, {{{{0, 0}, {4, 4}}}}}}));
}

TEST_F(PictureTest, DrawsMarksWhereTheyAreUsed) {
  const Picture picture = shown(
      "<defs><circle id='gpPt5' stroke-width='0.25' r='1'/>"
      "<use xlink:href='#gpPt5' id='gpPt6' fill='currentColor' stroke='none'/>"
      "<rect id='gpPt3' stroke-width='0.25' x='-1' y='-1' width='2' height='2'/>"
      "<use xlink:href='#gpPt3' id='gpPt11' stroke='currentColor' transform='rotate(180)'/></defs>"
      "<g id='gnuplot_plot_1'><g stroke-width='2.00'>"
      "<use xlink:href='#gpPt6' transform='translate(10.00,20.00) scale(4.00)' color='rgb(1,2,3)'/>"
      "<use xlink:href='#gpPt11' transform='translate(5.00,6.00) scale(2.00)' color='rgb(1,2,3)'/>"
      "</g></g>");
  ASSERT_EQ(picture.layers.size(), 2U);
  const Layer& marks = picture.layers[1];
  ASSERT_EQ(marks.size(), 2U);
  EXPECT_EQ(marks[0].first, (Brush{.stroke = "#010203", .width = "8", .cap = "round"}));
  EXPECT_EQ(marks[0].second, (std::vector<Outline>{{{{10, 20}}}}));
  EXPECT_EQ(marks[1].first, (Brush{.stroke = "#010203", .width = "0.5"}));
  ASSERT_EQ(marks[1].second.size(), 1U);
  EXPECT_NEAR(marks[1].second[0].corners[0].x, 7, 1e-9);  // turned by half a turn
  EXPECT_NEAR(marks[1].second[0].corners[0].y, 8, 1e-9);
}

TEST_F(PictureTest, TellsCellsFromTheBarOfColours) {
  std::string bar;
  for (int i = 0; i <= 5; ++i) {
    bar += "<polygon fill='rgb(0,0," + std::to_string(i) + ")' points='10," +
           std::to_string(90 - 10 * i) + " 20," + std::to_string(90 - 10 * i) + " 20," +
           std::to_string(80 - 10 * i) + " 10," + std::to_string(80 - 10 * i) + "'/>";
  }
  const Picture picture = shown(
      "<g stroke='none' shape-rendering='crispEdges'>" + bar +
      "</g><g id='gnuplot_plot_1'><g stroke='none' shape-rendering='crispEdges'>"
      "<polygon fill='rgb(255,0,0)' points='0,5 5,5 5,0 0,0 '/>"
      "<polygon fill='rgb(255,0,0)' fill-opacity='0.140000' points='0,5 5,5 5,0 0,0 '/></g></g>");
  ASSERT_TRUE(picture.bar);
  EXPECT_EQ(picture.bar->box, (Outline{{{10, 90}, {20, 90}, {20, 30}, {10, 30}}, true}));
  ASSERT_EQ(picture.bar->colours.size(), 6U);
  EXPECT_EQ(picture.bar->colours.front(), "#000000");
  EXPECT_EQ(picture.bar->colours.back(), "#000005");
  const Outline cell{{{0, 5}, {5, 5}, {5, 0}, {0, 0}}, true};
  EXPECT_EQ(picture.layers[1], (Layer{{{.fill = "#ff0000", .crisp = true}, {cell}},
                                      {{.fill = "#ff0000", .opacity = "0.14"}, {cell}}}));
}

TEST_F(PictureTest, ReadsTextsWithTheirPlaces) {
  const Picture picture = shown(
      "<g transform='translate(3.00,4.55) rotate(270.00)' fill='rgb(68,68,68)' font-family='Body' "
      "font-size='12.00' text-anchor='end'><text>1.25 &lt; rgb(1,2,3)</text></g>"
      "<g transform='translate(1,1)' fill='black'><text> </text></g>");
  ASSERT_EQ(picture.writings.size(), 1U);
  const Writing& writing = picture.writings[0];
  EXPECT_EQ(writing.text, "1.25 < rgb(1,2,3)");
  EXPECT_EQ(writing.fill, "#444444");
  EXPECT_EQ(writing.size, "12");
  EXPECT_EQ(writing.anchor, "end");
  EXPECT_EQ(writing.place, (Pixel{3, 4.55}));
  EXPECT_EQ(writing.turned, "rotate(270)");
}

TEST_F(PictureTest, RefusesWhatItDoesNotKnow) {
  EXPECT_THROW(shown("<image href='x'/>"), std::runtime_error);
  EXPECT_THROW(shown("<path d='M1,1 C2,2 3,3 4,4'/>"), std::runtime_error);
  EXPECT_THROW(shown("<use xlink:href='#gpPt99' transform='translate(1,1) scale(1)'/>"),
               std::runtime_error);
}

}  // namespace
}  // namespace ricochet::report
