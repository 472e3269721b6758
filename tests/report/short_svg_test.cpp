#include "src/report/short_svg.h"

#include <gtest/gtest.h>

#include <sstream>

namespace ricochet::report {
namespace {

std::string shortened(const char* inside) {
  pugi::xml_document document;
  document.load_string(
      (std::string("<svg><g id='gnuplot_canvas'>") + inside + "</g></svg>").c_str());
  shorten(document);
  std::ostringstream stream;
  for (const pugi::xml_node child : document.child("svg").child("g").children()) {
    child.print(stream, "", pugi::format_raw);
  }
  return stream.str();
}

constexpr const char* group =
    "<g fill='none' color='black' stroke='currentColor' stroke-width='1.00' "
    "stroke-linecap='butt' stroke-linejoin='miter'>";

TEST(ShortSvg, CutsCoordinatesAndWritesColoursShortly) {
  EXPECT_EQ(shortened("<path stroke='rgb(  0, 114, 178)' d='M85.42,10.00 L6.07,-310.89  '/>"),
            "<path stroke=\"#0072b2\" d=\"M85.4,10L6,-310.8\"/>");
  EXPECT_EQ(shortened("<polygon fill='#f7e85c' points='1.25,2.00 3,10.05 '/>"),
            "<polygon fill=\"#f7e85c\" points=\"1.2,2 3,10\"/>");
}

TEST(ShortSvg, LeavesMarksAsTheyAreDefined) {
  EXPECT_EQ(shortened("<defs><path d='M0,-1.33 L1.33,0.67 z'/></defs>"),
            "<defs><path d=\"M0,-1.33 L1.33,0.67 z\"/></defs>");
}

TEST(ShortSvg, SaysOnceWhatEveryGroupSays) {
  EXPECT_EQ(
      shortened((std::string(group) + "<path d='M1,2'/></g>" + group + "<rect/></g>").c_str()),
      "<path d=\"M1,2\"/><rect/>");
  EXPECT_EQ(shortened("<rect/><g fill='none' color='black' stroke='currentColor' "
                      "stroke-width='1.70'><path/></g>"),
            "<rect stroke=\"none\"/><g stroke-width=\"1.7\"><path/></g>");
}

TEST(ShortSvg, MakesATextOfAGroupOfOne) {
  EXPECT_EQ(shortened("<g transform='translate(3.00,4.55)' fill='rgb(68,68,68)'>"
                      "<text>1.25 rad/s, rgb(1,2,3)</text></g>"),
            "<text transform=\"translate(3,4.5)\" fill=\"#444444\">1.25 rad/s, rgb(1,2,3)</text>");
  // Of two texts neither is alone.
  EXPECT_EQ(shortened("<g transform='x'><text>a</text><text>b</text></g>"),
            "<g transform=\"x\"><text>a</text><text>b</text></g>");
}

}  // namespace
}  // namespace ricochet::report
