#include "src/report/text.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace ricochet::report {
namespace {

TEST(Text, OfMarkdownKeepsNamesReadable) {
  EXPECT_EQ(escape_markdown("lbfgs_b *x* _y_ <z>"), "lbfgs_b \\*x\\* \\_y\\_ &lt;z>");
}

TEST(Text, OfMarkdownHasNoLinksOfItsOwn) {
  EXPECT_EQ(escape_markdown("speed [rad/s], [a](b)"), "speed [rad/s], [a\\](b)");
}

TEST(Text, HasValuesInItsSlots) {
  EXPECT_EQ(with_slots("<{{a}}>{{b}}{{a}}", {{"a", "{{b}}"}, {"b", "2"}}), "<{{b}}>2{{b}}");
  EXPECT_THROW(with_slots("{{c}}", {{"a", "1"}}), std::out_of_range);
}

}  // namespace
}  // namespace ricochet::report
