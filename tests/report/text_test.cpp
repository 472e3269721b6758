#include "src/report/text.h"

#include <regex>

#include "ricochet/error.h"
#include "src/report/drawing.h"
#include "src/report/json.h"
#include "src/report/report.h"
#include "src/report/report_files.h"
#include "tests/support/files.h"
#include "tests/support/numbers.h"
#include "tests/support/refusals.h"

/// Texts, data and files of reports.

namespace ricochet::report {
namespace {

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
  EXPECT_THAT(text, Not(HasSubstr("<")));
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
  EXPECT_TRUE(Json(Whole{"C1", {}, {}})["count"].is_null());
}

TEST(StructAsJson, IsNotReadFromAnotherVersion) {
  for (const char* json : {R"({"case":"C1","count":3})", R"({"case":"C1","count":3,"parts":7})"})
    EXPECT_THROW(Json::parse(json).get<Whole>(), Json::exception);
  // What is left out is the same as null.
  EXPECT_FALSE(Json::parse(R"({"case":"C1","parts":[]})").get<Whole>().count);
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

using ReportFiles = TemporaryFolder;

/// Each name in a folder with its text, which of a folder and of a manifest is "".
using Content = std::map<std::string, std::string>;
Content content_of(const fs::path& folder) {
  Content found;
  for (const fs::path& path : fs::directory_iterator(folder)) {
    const bool is_text = fs::is_regular_file(path) && path.filename() != "manifest.txt";
    found[path.filename()] = is_text ? text_of(path) : "";
  }
  return found;
}

TEST_F(ReportFiles, ReplaceAnEarlierReportAndNothingElse) {
  const fs::path folder = folder_ / "a" / "b";
  replace_files(folder, {{"old.svg", "old"}, {"both.svg", "1"}, {"changed.svg", "old"}});
  write_file(folder / "notes.txt", "mine");
  write_file(folder / "logo.svg", "old");
  write_file(folder / "changed.svg", "by the user");
  replace_files(folder, {{"both.svg", "2"}, {"new.svg", "new"}});
  EXPECT_EQ(content_of(folder), (Content{{"manifest.txt", ""},
                                         {"both.svg", "2"},
                                         {"new.svg", "new"},
                                         {"notes.txt", "mine"},
                                         {"logo.svg", "old"},
                                         {"changed.svg", "by the user"}}));
}

TEST_F(ReportFiles, OfAManifestThatSomeoneWroteTouchNothingElsewhere) {
  for (const char* folder : {"a", "b"}) replace_files(folder_ / folder, {{"old.svg", "old"}});
  const fs::path manifest = folder_ / "a" / "manifest.txt";
  write_file(manifest, std::regex_replace(text_of(manifest), std::regex("old"), "../b/old"));
  replace_files(folder_ / "a", {{"new.svg", "new"}});
  EXPECT_TRUE(fs::exists(folder_ / "b" / "old.svg"));
}

TEST_F(ReportFiles, AreNotWrittenIntoAFolderThatCannotBe) {
  const fs::path file = write_file(folder_ / "file", "mine");
  for (const fs::path& folder : {file, file / "deeper" / "still"}) {
    EXPECT_THAT(complaint_of([&] {
                  replace_files(folder, {{"new.svg", "new"}});
                }),
                AllOf(HasSubstr(file.string()), Not(HasSubstr("\n"))));
  }
  EXPECT_EQ(content_of(folder_), (Content{{"file", "mine"}}));
}

TEST_F(ReportFiles, StayAsTheyWereIfOneCannotBeReplaced) {
  replace_files(folder_, {{"index.html", "before"}, {"old.svg", "old"}});
  fs::create_directory(folder_ / "new.svg");
  EXPECT_THROW(replace_files(folder_, {{"index.html", "after"}, {"new.svg", "new"}}), InputError);
  EXPECT_EQ(
      content_of(folder_),
      (Content{
          {"index.html", "before"}, {"manifest.txt", ""}, {"old.svg", "old"}, {"new.svg", ""}}));
}

/// Results that no page fits: drawing them fails.
Json unfit(const char* report) {
  return {{"report", report}, {"computed", "for hours"}};
}

TEST_F(ReportFiles, KeepTheDataOfAllPagesOfAReportThatCannotBeDrawn) {
  Json data = unfit("comparison");
  for (const char* name : {"one", "two"})
    data["pages"].push_back({{"folder", name}, {"data", unfit("comparison_family")}});
  EXPECT_THROW(static_cast<void>(write_report(data, folder_)), std::logic_error);
  const auto kept = [&](const char* folder) {
    return data_in(text_of(folder_ / folder / "data.json"));
  };
  data["pages"] = {"one", "two"};
  EXPECT_EQ(kept(""), data);
  for (const char* name : {"one", "two"}) EXPECT_EQ(kept(name), unfit("comparison_family"));
}

}  // namespace
}  // namespace ricochet::report
