#include "src/report/text.h"

#include "src/report/drawing.h"
#include "src/report/json.h"
#include "tests/support/files.h"
#include "tests/support/numbers.h"
#include "tests/support/test.h"

namespace ricochet::report {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(Text, OfMarkdownKeepsNamesReadableAndHasNoLinksOfItsOwn) {
  EXPECT_EQ(escape_markdown("lbfgs_b *x* _y_ <z>"), "lbfgs_b \\*x\\* \\_y\\_ &lt;z>");
  EXPECT_EQ(escape_markdown("speed [rad/s], [a](b)"), "speed [rad/s], [a\\](b)");
}

TEST(Text, HasValuesInItsSlots) {
  EXPECT_EQ(with_slots("<{{a}}>{{b}}{{a}}", {{"a", "{{b}}"}, {"b", "2"}}), "<{{b}}>2{{b}}");
  EXPECT_THROW(with_slots("{{c}}", {{"a", "1"}}), std::out_of_range);
}

TEST(ScriptText, HasTheSameDataAndEndsNoScript) {
  const Json data = {"</script><b>", "a < b"};
  const std::string text = json_in_script(data.dump());
  EXPECT_EQ(text.find('<'), std::string::npos);
  EXPECT_EQ(Json::parse(text), data);
}

TEST(TextWidth, IsThatOfABrowserWithTheWidestUsualFont) {
  // As Chromium draws them in DejaVu Sans of 12 pixels.
  EXPECT_NEAR(text_width("processor time per impact [s]"), 177.6, 1.8);
  EXPECT_NEAR(text_width("relative difference"), 109.3, 1.7);
  EXPECT_NEAR(text_width("pagmo-cmaes-tuned"), 124.7, 1.2);
  EXPECT_NEAR(text_width("1000"), 30.5, 0.5);
  EXPECT_NEAR(text_width("evaluations for each variable"), 174.7, 1.7);
  EXPECT_NEAR(text_width("border: the carrier starts to move"), 201.2, 2.0);
}

TEST(TextWidth, CountsCharactersAndNotBytes) {
  EXPECT_EQ(text_width("ωω"), 2 * text_width("ω"));
  EXPECT_EQ(text_width("ω"), text_width("é"));
  EXPECT_EQ(text_width("abc", 24), 2 * text_width("abc"));
}

TEST(Shortened, EndsBetweenCharactersWithAnEllipsisWhereThereIsNoRoom) {
  EXPECT_EQ(shortened("speed", text_width("speed")), "speed");
  EXPECT_EQ(shortened("ωωωωωω", text_width("ωωω…")), "ωωω…");
  EXPECT_EQ(shortened("abcdef", 5), "…");
}

TEST(Wrapped, BreaksAtSpaces) {
  EXPECT_THAT(wrapped("one two three", text_width("one two")), ElementsAre("one two", "three"));
  EXPECT_THAT(wrapped("one  two", 100), ElementsAre("one  two"));
  EXPECT_THAT(wrapped("incomprehensible word", 56), ElementsAre("incomprehensible", "word"));
  EXPECT_THAT(wrapped("", 100), IsEmpty());
}

TEST(DataText, KeepsWholeNumbersExactlyAndOfOthersTheDigitsThatMeanSomething) {
  for (const auto& [number, digits, text] :
       {std::tuple{8.274912345, 6, "8.27491"},
        {8.274912345, 17, "8.274912345"},
        {-1.23456789e-12, 6, "-1.23457e-12"},
        {2.0 / 3, 2, "0.67"},
        {123456789.0, 6, "123456789"},
        {-9007199254740991.0, 2, "-9007199254740991"},
        {1.5e300, 6, "1.5e+300"},
        {-1.23456789e-308, 6, "-1.23457e-308"},
        {5e-324, 6, "5e-324"},
        {1.797693134e308, 6, "1.79769e+308"},
        {1.7976931e308, 2, "1.7976931e+308"},  // 1.8e308 is beyond all numbers
        {quiet_nan, 6, "null"},
        {infinity, 6, "null"}}) {
    EXPECT_EQ(rounded(number, digits).dump(), text);
  }
}

TEST(DataText, HasTheFewestDigits) {
  EXPECT_EQ(Json(0.02414).dump(), "0.024140000000000002") << "else this test is not needed";
  EXPECT_EQ(json_text({{"a", {0.02414, -1e-12, 1.5e300, 2, "x", nullptr}}, {"b", Json::object()}}),
            "{\"a\":[0.02414,-1e-12,1.5e+300,2,\"x\",null],\"b\":{}}\n");
}

TEST(DataText, IsReadBackAndHasNoLongLine) {
  Json data = {{"rows", Json::array()}, {"plain", Json::array()}};
  for (int i = 0; i < 300; ++i) {
    data["rows"].push_back({{"x", i / 7.0}, {"name", "a \"b\"\n"}});
    data["plain"].push_back(i / 9.0);
  }
  const std::string text = json_text(data);
  EXPECT_EQ(data_in(text), data);
  for (const std::string& line : lines_of(text)) EXPECT_LT(line.size(), 140U) << line;
}

TEST(DataText, IsNotReadIfItIsNone) {
  EXPECT_THROW(data_in("{"), Json::exception);
  EXPECT_THROW(data_in(std::string(200, '[') + std::string(200, ']')), std::logic_error);
}

struct Piece {
  double number;
  std::vector<double> numbers = {};
};
RICOCHET_FIELDS(Piece, number, numbers);

struct Whole {
  std::string case_;
  std::optional<int> count;
  std::vector<Piece> parts;
};
RICOCHET_FIELDS(Whole, case_, count, parts);

TEST(StructAsJson, HasItsMembersInOrderAndIsReadBack) {
  const Json json = Whole{"C1", 3, {{0.5}, {infinity, {1, -infinity}}}};
  EXPECT_EQ(json.dump(), R"({"case":"C1","count":3,"parts":[{"number":0.5,"numbers":[]},)"
                         R"({"number":null,"numbers":[1.0,null]}]})");
  const Json finite = Whole{"C1", 3, {{0.5, {1, 2}}}};
  EXPECT_EQ(Json(finite.get<Whole>()), finite);
  const Json without = Whole{"C1", {}, {}};
  EXPECT_TRUE(without["count"].is_null());
  EXPECT_FALSE(without.get<Whole>().count);
}

TEST(StructAsJson, IsNotReadFromAnotherVersion) {
  Json json = Whole{"C1", 3, {}};
  json.erase("parts");
  EXPECT_THROW(json.get<Whole>(), Json::exception);
  json["parts"] = 7;
  EXPECT_THROW(json.get<Whole>(), Json::exception);
  json["parts"] = Json::array();
  json.erase("count");  // the same as null
  EXPECT_FALSE(json.get<Whole>().count);
}

TEST(Counted, HasThePluralBesideAllButOne) {
  EXPECT_EQ(counted(0, "run"), "0 runs");
  EXPECT_EQ(counted(1, "run"), "1 run");
  EXPECT_EQ(counted(2, "run"), "2 runs");
  EXPECT_EQ(counted(1, "entry", "entries"), "1 entry");
  EXPECT_EQ(counted(12, "entry", "entries"), "12 entries");
}

TEST(SecondsText, HasTheUnitThatMakesANumberOfAtLeastOne) {
  EXPECT_EQ(seconds_text(2.5e-7), "0.25 µs");
  EXPECT_EQ(seconds_text(1.25e-6), "1.25 µs");
  EXPECT_EQ(seconds_text(0.0123), "12.3 ms");
  EXPECT_EQ(seconds_text(1), "1 s");
  EXPECT_EQ(seconds_text(0.01234, 2), "12 ms");
}

}  // namespace
}  // namespace ricochet::report
