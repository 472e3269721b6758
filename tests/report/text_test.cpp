#include "src/report/text.h"

#include <gtest/gtest.h>

namespace ricochet::report {
namespace {

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
