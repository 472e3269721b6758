#include "src/core/names.h"

#include "tests/support/refusals.h"
#include "tests/support/test.h"

namespace ricochet {
namespace {

using Names = std::vector<std::string>;

TEST(Name, IsOfLettersDigitsAndFourCharacters) {
  for (const std::string& name :
       Names{"a", "C1", "nlopt-cobyla", "my_solver.2+", "-x", std::string(60, 'x')}) {
    EXPECT_TRUE(is_name(name)) << name;
  }
  for (const std::string& text :
       Names{"", "a b", "a/b", "..", ".hidden", "=cmd", "@SUM(1)", "'", "a'b", "\x1b[31m", "\u202e",
             "\xc3\xa4", "a\n", std::string(61, 'x')}) {
    EXPECT_FALSE(is_name(text)) << text;
  }
}

TEST(EditDistance, CountsWhatMustBeChanged) {
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("teh", "the"), 1);
  EXPECT_EQ(edit_distance("Omega", "omega"), 0);
}

TEST(NearNames, AreTheNearestThreeMistypedOrShortened) {
  const Names known = {"simulate", "threshold", "profile-count-2-C1"};
  for (const auto& [wanted, near] :
       std::vector<std::pair<std::string, Names>>{{"simulte", {"simulate"}},
                                                  {"thresh", {"threshold"}},
                                                  {"profile-2-C1", {"profile-count-2-C1"}},
                                                  {"hammer", {}},
                                                  {std::string(1'000'000, 's'), {}}}) {
    EXPECT_EQ(near_names(wanted, known), near) << wanted.substr(0, 20);
  }
  EXPECT_THAT(near_names("C", {"C1", "C", "C2", "C3"}), ElementsAre("C", "C1", "C2"));
}

TEST(WhatInstead, NamesWhatIsNearOrElseWhatIsAllowedUpToSixty) {
  for (const char* listing : {"", "`ricochet list`"}) {
    EXPECT_EQ(what_instead("masss", {"mass", "pull"}, listing), "did you mean mass?");
  }
  EXPECT_EQ(what_instead("weight", {"mass", "pull"}, "`ricochet list`"), "see `ricochet list`");
  EXPECT_EQ(what_instead("weight", {"mass", "pull"}), "allowed: mass, pull");
  Names known;
  for (int number = 0; number < 300; ++number) known.push_back(std::to_string(1000 + number));
  EXPECT_THAT(what_instead("weight", known),
              AllOf(StartsWith("allowed: 1000, 1001, "), EndsWith(", 1059, and 240 more")));
  known.resize(60);
  EXPECT_THAT(what_instead("weight", known), EndsWith(", 1059"));
}

TEST(Match, IsExactOrTheOnlyOneInAnyCase) {
  const Names known = {"count-C1", "Mass", "mass"};
  EXPECT_EQ(match("COUNT-c1", known), &known[0]);
  EXPECT_EQ(match("mass", known), &known[2]);
  EXPECT_EQ(match("MASS", known), nullptr);
  EXPECT_EQ(match("count", known), nullptr);
}

TEST(OneLine, EscapesWhatSteersATerminalOrReordersALine) {
  for (const auto& [text, line] : std::vector<std::pair<std::string, std::string>>{
           {"a.toml: Größe = 3: must be > 0", "a.toml: Größe = 3: must be > 0"},
           {"a\nb\x1b[31m\x7f", "a\\x0ab\\x1b[31m\\x7f"},
           {std::string("\xc2\x9b") + "31m", "\\xc2\\x9b31m"},  // the same in one character
           {"\xff\xc3", "\\xff\\xc3"},
           {"\xc3(", "\\xc3("},  // no second byte of a character
           {"a\u202eb\u2066\u200f", "a\\xe2\\x80\\xaeb\\xe2\\x81\\xa6\\xe2\\x80\\x8f"},
           {"\u061c\u2028", "\\xd8\\x9c\\xe2\\x80\\xa8"},
           {"\u200e\u2069", "\\xe2\\x80\\x8e\\xe2\\x81\\xa9"},           // the first and the last
           {"\u200d\u2010\u2065\u206a", "\u200d\u2010\u2065\u206a"}}) {  // just beside them
    EXPECT_EQ(one_line(text), line);
  }
}

TEST(OneLine, LeavesTheMiddleOfALongTextOut) {
  const std::string line = one_line("start" + std::string(10'000'000, 'x') + "end");
  EXPECT_LT(line.size(), 5000U);
  EXPECT_THAT(line, AllOf(StartsWith("start"), EndsWith("end")));
}

TEST(Patterns, FitTheWholeNameAndAreReadWithCommasBetween) {
  const std::pair<const char*, bool> lists[] = {
      {"top-speed-C[14]", true}, {"top-speed-C[24]", false}, {"top-speed", false},
      {"count-*,,top-*", true},  {"count-*", false},         {"", false}};
  for (const auto& [list, fit] : lists) {
    EXPECT_EQ(fits_any("top-speed-C1", split_patterns(list)), fit) << list;
  }
  EXPECT_FALSE(fits("top-speed-C1", ""));
  EXPECT_THAT(split_patterns("count-*,,C[14]"), ElementsAre("count-*", "C[14]"));
}

TEST(Patterns, AreRefusedWhereNothingFits) {
  const auto complaint = [](const std::string& pattern, const Names& names,
                            const std::string& listing = "") {
    return complaint_of([&] {
      require_fit({pattern}, names, "--solvers", listing);
      return 0;
    });
  };
  require_fit({"none", "cob*"}, {"cobyla", "scan"}, "--solvers");
  EXPECT_EQ(complaint("coblya", {"cobyla", "scan"}),
            "--solvers coblya: nothing fits; did you mean cobyla?");
  EXPECT_EQ(complaint("simplex", {"cobyla", "scan"}, "`ricochet list solvers`"),
            "--solvers simplex: nothing fits; see `ricochet list solvers`");
  EXPECT_THAT(complaint("*", {}), StartsWith("--solvers *: nothing fits"));
}

TEST(Label, IsTheTextUnlessItIsReadAsAMissingValue) {
  EXPECT_EQ(label("nan"), "missing-value");
  for (const char* missing : {"NA", "N/A", "n/a", "NaN", "-nan", "null", "NULL", "None", "<NA>"}) {
    EXPECT_EQ(label(missing), "'" + std::string(missing));
  }
  for (const char* text : {"", "plain", "none", "nano", "banana", "NAN", "nlopt-cobyla"}) {
    EXPECT_EQ(label(text), text);
  }
}

TEST(NumberOfText, ReadsTheWholeTextOrNothing) {
  EXPECT_EQ(number_of_text<int>("17"), 17);
  EXPECT_EQ(number_of_text<int>("-3"), -3);
  EXPECT_EQ(number_of_text<double>("1e-3"), 1e-3);
  EXPECT_EQ(number_of_text<std::int64_t>("9007199254740993"), 9007199254740993);
  for (const char* text : {"", " 1", "1 ", "1a", "1.5", "+1", "0x1", "99999999999"}) {
    EXPECT_EQ(number_of_text<int>(text), std::nullopt) << text;
  }
  EXPECT_EQ(number_of_text<unsigned>("-1"), std::nullopt);
}

}  // namespace
}  // namespace ricochet
