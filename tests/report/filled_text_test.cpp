#include <gmock/gmock.h>

#include <stdexcept>

#include "src/report/text.h"

namespace ricochet::report {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const Json data = {{"count", 7},
                   {"speed", 8.274462951660155},
                   {"share", 0.1234},
                   {"little", -0.0012},
                   {"none", nullptr},
                   {"zero", 0},
                   {"no", false},
                   {"word", "a < b & \"c\""},
                   {"within", {{"speed", 2.0}, {"deep", {{"count", 3}}}}},
                   {"list", {{{"name", "x"}, {"speed", 1.5}}, {{"name", "y"}}}},
                   {"numbers", {1, 2, 3}},
                   {"empty", Json::array()}};

std::string text(const std::string& from) {
  return filled(from, {&data});
}

TEST(FilledText, FormatsNumbersAsFmtDoes) {
  EXPECT_EQ(text("{{count}} at {{speed:.2f}} rad/s"), "7 at 8.27 rad/s");
  EXPECT_EQ(text("{{speed:+.1e}}"), "+8.3e+00");
  EXPECT_EQ(text("{{speed}}"), "8.274462951660155");
  EXPECT_EQ(text("{{count:.1f}}"), "7.0");
  EXPECT_EQ(text("{{count:>3}}|"), "  7|");
}

TEST(FilledText, ShowsSharesAsHundredths) {
  EXPECT_EQ(text("{{share:.1%}} %"), "12.3 %");
}

TEST(FilledText, ShowsWhatIsMissingAsADash) {
  EXPECT_EQ(text("{{none:.2f}}"), "–");
}

TEST(FilledText, GivesWhatRoundsToZeroNoSign) {
  EXPECT_EQ(text("{{little:.2f}} {{little:+.1f}} {{little:.4f}}"), "0.00 +0.0 -0.0012");
}

TEST(FilledText, EscapesNothing) {
  EXPECT_EQ(text("{{word}}"), "a < b & \"c\"");
}

TEST(FilledText, LooksUpWithinMembers) {
  EXPECT_EQ(text("{{within.deep.count}}"), "3");
  EXPECT_EQ(text("{{#within}}{{speed:.0f}} of {{count}}{{/within}}"), "2 of 7");
}

TEST(FilledText, TakesNullFalseAndEmptyForNoAndZeroForYes) {
  EXPECT_EQ(text("{{#none}}a{{/none}}{{#no}}b{{/no}}{{#empty}}c{{/empty}}{{#zero}}d{{/zero}}"),
            "d");
  EXPECT_EQ(text("{{^none}}a{{/none}}{{^no}}b{{/no}}{{^empty}}c{{/empty}}{{^zero}}d{{/zero}}"),
            "abc");
}

TEST(FilledText, RepeatsWhatStandsForAList) {
  EXPECT_EQ(text("{{#list}}{{^@first}}, {{/@first}}{{name}} {{speed:.1f}}{{/list}}"),
            "x 1.5, y 8.3");
  EXPECT_EQ(text("{{#numbers}}{{^@first}}, {{/@first}}{{.:.1f}}{{/numbers}}"), "1.0, 2.0, 3.0");
  EXPECT_EQ(text("{{#numbers}}{{#@first}}{{.:.1f}} to{{/@first}}{{#@last}} "
                 "{{.:.1f}}{{/@last}}{{/numbers}}"),
            "1.0 to 3.0");
}

TEST(FilledText, LooksInTheInnermostScopeFirst) {
  const Json inner = {{"speed", 1.0}};
  EXPECT_EQ(filled("{{speed:.0f}} {{count}}", {&data, &inner}), "1 7");
}

TEST(FilledText, RefusesANameWithoutData) {
  for (const char* wrong : {"{{sped}}", "{{#sped}}{{/sped}}", "{{^sped}}{{/sped}}",
                            "{{within.sped:.1f}}", "{{#within}}{{sped}}{{/within}}"}) {
    EXPECT_THAT([&] { text(wrong); }, ThrowsMessage<std::logic_error>(HasSubstr("sped"))) << wrong;
  }
}

TEST(FilledText, RefusesAFormulationThatDoesNotFit) {
  EXPECT_THAT([] { text("{{word:.2f}}"); }, ThrowsMessage<std::logic_error>(HasSubstr("word")));
  EXPECT_THAT([] { text("{{list:.2f}}"); }, ThrowsMessage<std::logic_error>(HasSubstr("list")));
}

TEST(FilledText, RefusesATextThatIsNoMustache) {
  EXPECT_THAT([] { text("{{#list}} never ends"); },
              ThrowsMessage<std::logic_error>(HasSubstr("list")));
}

}  // namespace
}  // namespace ricochet::report
