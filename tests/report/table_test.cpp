#include "src/report/table.h"

#include <gmock/gmock.h>

#include <stdexcept>

#include "src/report/text.h"

namespace ricochet::report {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const Table thresholds{"Thresholds [rad/s]",
                       {{"case", Alignment::left}, {"threshold"}},
                       {{{"C1"}, {"8.97", State::good}}, {{"C2"}, {"3", State::bad}}}};

TEST(Table, IsMarkdown) {
  EXPECT_EQ(to_markdown(thresholds),
            "Thresholds [rad/s]\n\n"
            "| case | threshold |\n"
            "| :--- | ---: |\n"
            "| C1 | ✓ 8.97 |\n"
            "| C2 | ✗ 3 |\n");
}

TEST(Table, ShowsStatesInHtmlByColourAndByText) {
  EXPECT_THAT(to_html(thresholds),
              AllOf(HasSubstr("class=\"right good\""), HasSubstr("aria-label=\"good\">✓<"),
                    HasSubstr("class=\"right bad\""), HasSubstr("aria-label=\"bad\">✗<")));
}

TEST(Table, EscapesHtmlEverywhere) {
  const Table table{"<i>", {{"<i>"}}, {{{"<i>", State::good}}, {{"<i>"}}}};
  EXPECT_THAT(to_html(table), AllOf(HasSubstr("&lt;i&gt;"), Not(HasSubstr("<i>"))));
}

TEST(Table, KeepsAPipeWithinItsCell) {
  EXPECT_THAT(to_markdown({"", {{"a|b"}}, {{{"c\nd|e"}}}}),
              AllOf(HasSubstr("| a\\|b |"), HasSubstr("| c d\\|e |")));
}

TEST(Table, RefusesARowOfTheWrongLength) {
  const Table table{"t", {{"a"}, {"b"}}, {{{"1"}}}};
  EXPECT_THROW(to_html(table), std::invalid_argument);
  EXPECT_THROW(to_markdown(table), std::invalid_argument);
}

TEST(Text, OfMarkdownKeepsNamesReadable) {
  EXPECT_EQ(escape_markdown("lbfgs_b *x* _y_ <z>"), "lbfgs_b \\*x\\* \\_y\\_ &lt;z>");
}

TEST(Text, OfMarkdownHasNoLinksOfItsOwn) {
  EXPECT_EQ(escape_markdown("speed [rad/s], [a](b)"), "speed [rad/s], [a\\](b)");
}

TEST(Text, LinksAddressesButNotTheFullStopAfterThem) {
  EXPECT_EQ(html_with_links("See https://doi.org/10.1/x?a&b. <End>"),
            "See <a href=\"https://doi.org/10.1/x?a&amp;b\">https://doi.org/10.1/x?a&amp;b</a>. "
            "&lt;End&gt;");
}

}  // namespace
}  // namespace ricochet::report
