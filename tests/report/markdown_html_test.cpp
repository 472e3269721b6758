#include "src/report/markdown_html.h"

#include <gmock/gmock.h>

namespace ricochet::report {
namespace {

using testing::HasSubstr;
using testing::Not;

HtmlPage converted(const std::string& markdown) {
  return html_page(markdown, {.target = [](const std::string& link) {
                     return link == "no" ? "" : "to/" + link;
                   }});
}

TEST(Markdown, HasAnchorsAsCodeHostsMakeThem) {
  const HtmlPage document =
      converted("# What it *is*: 3 of 4\n\nFirst.\n\n## A `b_c` d\n\nSecond.\n");
  EXPECT_EQ(document.title, "What it is: 3 of 4");
  EXPECT_THAT(document.html, HasSubstr("<section id=\"a-b_c-d\""));
  ASSERT_EQ(document.parts.size(), 2U);
  EXPECT_EQ(document.parts[1].anchor, "a-b_c-d");
  EXPECT_THAT(document.parts[1].text, HasSubstr("Second."));
  EXPECT_THAT(document.parts[0].text, Not(HasSubstr("Second.")));
}

TEST(Markdown, LeadsLinksAndPicturesWhereTheSiteHasThem) {
  const std::string html = converted("[one](a.md) [two](no) ![three](b.svg) ![four](no)").html;
  EXPECT_THAT(html, HasSubstr("<a href=\"to/a.md\">one</a>"));
  EXPECT_THAT(html, HasSubstr("<span>two</span>"));
  EXPECT_THAT(html, HasSubstr("<img src=\"to/b.svg\" alt=\"three\">"));
  EXPECT_THAT(html, HasSubstr("<span>four</span>"));
}

TEST(Markdown, HasTablesAndListingsThatScroll) {
  const std::string html =
      converted(
          "# T\n\n| a | b |\n|:--|--:|\n| 1 < 2 | `x` |\n\n```console\n$ run\n\n$ stop\n```\n")
          .html;
  EXPECT_THAT(html, HasSubstr("<div class=\"scroll\" role=\"region\" aria-label=\"table 1: T\""));
  EXPECT_THAT(html, HasSubstr("<td class=\"right\"><code>x</code></td>"));
  EXPECT_THAT(html, HasSubstr("1 &lt; 2"));
  EXPECT_THAT(html, HasSubstr("<pre tabindex=\"0\">"));
  EXPECT_THAT(html, HasSubstr("$ run\n\n$ stop"));
}

TEST(Markdown, HasTitlesInTheRowsOfATableOnANarrowScreen) {
  const auto table = [](const char* titles) {
    return converted(std::string("# T\n\n") + titles + "\n|:--|:--|:--|:--|\n| 1 | 2 | 3 | 4 |\n")
        .html;
  };
  EXPECT_THAT(table("| a | b < c | the \"best\" | f; |"),
              HasSubstr("style=\"--1:&quot;a&quot;;--2:&quot;b &lt; c&quot;;--3:&quot;the "
                        "\\&quot;best\\&quot;&quot;;--4:&quot;f;&quot;;\""));
  EXPECT_THAT(converted("| a | b |\n|:--|:--|\n| 1 | 2 |\n").html, Not(HasSubstr("--1:")));
}

TEST(Markdown, DropsComments) {
  EXPECT_THAT(converted("<!-- not run: long -->\n\nText.\n").html, Not(HasSubstr("not run")));
}

}  // namespace
}  // namespace ricochet::report
