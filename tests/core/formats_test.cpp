#include "src/core/csv.h"
#include "src/core/fields.h"
#include "src/core/toml.h"
#include "src/core/toml_fields.h"
#include "tests/support/numbers.h"
#include "tests/support/refusals.h"
#include "tests/support/test.h"

namespace ricochet {
namespace {

TEST(CsvField, IsQuotedWhereItWouldEndAndIsNoFormula) {
  const std::pair<const char*, const char*> fields[] = {
      {"", ""},
      {"nlopt-cobyla", "nlopt-cobyla"},
      {"a,b", "\"a,b\""},
      {"a\"b", "\"a\"\"b\""},
      {"a\nb", "\"a\nb\""},
      {"=cmd|' /C calc'!A0", "'=cmd|' /C calc'!A0"},
      {"@SUM(1)", "'@SUM(1)"},
      {"+1+1", "'+1+1"},
      {"-1+1,2", "\"'-1+1,2\""},
      {"\t=1", "'\t=1"},
      {"\r=1", "\"'\r=1\""}};
  for (const auto& [text, field] : fields) EXPECT_EQ(csv_field(text), field);
  for (const char* number : {"-1.5", "-inf", "-3e-07", "0", "nan"}) {
    EXPECT_EQ(csv_field(number), number);
  }
}

CsvTable table_of(const std::string& text) {
  return parse_csv_table(text, "f.csv", {"time", "omega"});
}

const std::string mark = "\xef\xbb\xbf";

TEST(CsvTable, HasColumnsOfNumbersAndMayBeginWithAByteOrderMark) {
  for (const std::string& begin : {std::string(), mark}) {
    const CsvTable table =
        table_of(begin + "# made by hand\r\nomega , time\r\n1, 2.5\r\n\r\n-3e2,+4\n");
    EXPECT_THAT(table.column("time"), ElementsAre(2.5, 4));
    EXPECT_THAT(table.column("omega"), ElementsAre(1, -300));
    EXPECT_THAT(table.lines, ElementsAre(3, 5));
    EXPECT_EQ(table.find("strength"), nullptr);
    for (const char* text : {"time\n1\n", "\n time\n1\n"}) {
      EXPECT_THAT(table_of(begin + text).column("time"), ElementsAre(1));
    }
  }
}

TEST(CsvTable, IsRefusedWithFileLineAndColumn) {
  expect_refusals(table_of, {{"", "f.csv: must have a header"},
                             {mark, "f.csv: must have a header"},
                             {"time\n" + mark + "1\n", "f.csv:2: column time"},
                             {"time\n", "lines of numbers"},
                             {"tine\n1\n", "f.csv:1: column tine: did you mean time"},
                             {"time,time\n1,2\n", "f.csv:1: column time is there twice"},
                             {"time,omega\n1\n", "f.csv:2: 1 fields: must be 2"},
                             {"time\n1\nx\n", "f.csv:3: column time: 'x': must be a finite"},
                             {"time\n1e999\n", "must be a finite number"},
                             {"time\nnan\n", "must be a finite number"},
                             {"time,omega\n1,\n", "column omega: ''"}});
  EXPECT_THROW(read_csv_table("/nowhere/f.csv", {"time"}), InputError);
  const auto is_positive = [](auto, double t) { return t > 0; };
  const auto check = [&] {
    return table_of("time\n1\n\n-2\n").require("time", is_positive, "> 0"), 0;
  };
  EXPECT_EQ(complaint_of(check), "f.csv:4: column time: -2: must be > 0");
}

std::string complaint_about(const std::string& text) {
  return complaint_of([&] { return parse_toml(text, "file"); });
}

/// A key of so many names.
std::string key_of(int names) {
  std::string key = "a";
  for (int i = 1; i < names; ++i) key += i % 2 == 0 ? ".a" : " . \"a\"";
  return key;
}

TEST(TomlText, ShowsAValueInOneLine) {
  const toml::table table = parse_toml(
      "value = ['word', \"it's\", -3, 0.1, 2.0, true, [], [[1]], {a = 1}, 1979-05-27, "
      "07:32:05.5, 1979-05-27T07:32:05Z]",
      "file");
  EXPECT_EQ(toml_value(*table.get("value")),
            "[ 'word', \"it's\", -3, 0.1, 2.0, true, [], [ [ 1 ] ], {...}, 1979-05-27, 07:32:05, "
            "1979-05-27T07:32:05 ]");
}

TEST(TomlText, GivesAKeyTodaysName) {
  toml::table table = parse_toml("old = 1\nboth = 2\nnew_both = 3", "file");
  testing::internal::CaptureStderr();
  rename_key(table, "old", "new", "file: ");
  rename_key(table, "both", "new_both", "file: ");
  rename_key(table, "absent", "new_absent", "file: ");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "warning: file: old is now called new\n");
  EXPECT_EQ(table, parse_toml("new = 1\nboth = 2\nnew_both = 3", "file"));
}

TEST(TomlText, IsTakenUpToItsLimits) {
  // The deepest that the limits leave: the reader has one of its own for values within values.
  std::string deepest = "x = ", list = "x = [";
  for (int i = 0; i < 250; ++i) deepest += "{" + key_of(deepest_toml) + " = ";
  for (int i = 0; i < 1000; ++i) list += "[0.5, 1.5], ";  // dots of numbers are not counted
  const std::string longest = "#" + std::string(longest_toml - 1, 'x');
  for (const std::string& text :
       {"[" + key_of(deepest_toml) + "]", key_of(deepest_toml) + " = 1", longest, list + "]",
        deepest + "1" + std::string(250, '}'), "x = 1  # " + std::string(200, '.')}) {
    EXPECT_EQ(complaint_about(text), "accepted") << text.substr(0, 100);
  }
  for (const int names : {deepest_toml + 1, 50'000}) {
    for (const std::string& text : {"[" + key_of(names) + "]", "[[" + key_of(names) + "]]",
                                    key_of(names) + " = 1", "x = {" + key_of(names) + " = 1}"}) {
      EXPECT_THAT(complaint_about("x_1 = 1\n" + text),
                  StartsWith("file:2: a key has more than 32 names"));
    }
  }
  EXPECT_THAT(complaint_about("x = " + std::string(100'000, '[')), HasSubstr("nested"));
  EXPECT_EQ(complaint_about(longest + "x"), "file: too long: must have at most 4000000 bytes");
}

TEST(TomlFile, SaysWhyAFileCannotBeReadAndReadsNoMoreThanItMayHave) {
  expect_refusals(parse_toml_file,
                  {{"/nothing/there.toml", "/nothing/there.toml: there is no such file"},
                   {"/dev/null/there", "/dev/null/there: cannot be read: Not a directory"},
                   {"/", "/: cannot be read: Is a directory"},
                   {"/dev/zero", "/dev/zero: too long"}});
  EXPECT_TRUE(parse_toml_file("/dev/null").empty());
}

enum class Colour { red, green };

const EnumNames<Colour>& names_of(Colour /*value*/) {
  static const EnumNames<Colour> names = {{"red", Colour::red}, {"green", Colour::green}};
  return names;
}

/// A struct within another one.
struct Inner {
  double length = 0.5;
  bool operator==(const Inner&) const = default;
};

template <class Visit, IsOf<Inner>... I>
void visit_fields(const Visit& visit, I&... i) {
  visit(Field{"length", "m", "", positive_number, Presence::stated}, i.length...);
}

/// A struct with a member of every kind.
struct Outer {
  std::string name = "a";
  double number = 1;
  int count = 3;
  bool flag = false;
  Colour colour = Colour::red;
  std::optional<double> perhaps = {};
  std::vector<std::string> words = {"*"};
  std::vector<std::int64_t> steps = {};
  std::array<double, 2> pair = {};
  Vector point = Vector::Zero(2);
  GivenOptions options = {};
  Inner inner = {};
  std::vector<Inner> list = {};
  std::map<std::string, Inner> others = {};
};

template <class Visit, IsOf<Outer>... O>
void visit_fields(const Visit& visit, O&... o) {
  using enum Presence;
  visit(Field{"name", "", "", {}, required}, Name{o.name}...);
  visit(Field{"number"}, o.number...);
  visit(Field{"count", "1", "", whole_number(1, 9)}, o.count...);
  visit(Field{"flag"}, o.flag...);
  visit(Field{"colour"}, o.colour...);
  visit(Field{"perhaps", "1", "", {.least = 0, .most = 1, .without_most = true}}, o.perhaps...);
  visit(Field{"words", "", "", {}, optional, Entries::distinct}, o.words...);
  visit(Field{"steps", "1", "", whole_number(0), optional, Entries::rising}, o.steps...);
  visit(Field{"pair"}, o.pair...);
  visit(Field{"point"}, o.point...);
  visit(Field{"options"}, o.options...);
  visit(Field{"inner"}, o.inner...);
  visit(Field{"list"}, o.list...);
  visit(Field{other_keys}, o.others...);
}

Outer any_outer(std::mt19937_64& random) {
  const auto number = [&] { return std::ldexp(static_cast<double>(random()), -60) - 8; };
  const auto yes = [&] { return random() % 2 == 0; };
  const auto text = [&] {
    return std::string(1 + random() % 3, static_cast<char>(random() % 127));
  };
  Outer outer;
  outer.name = yes() ? "b-1" : "c";
  if (yes()) outer.number = yes() ? number() : infinity;
  if (yes()) outer.count = static_cast<int>(1 + random() % 9);
  outer.flag = yes();
  if (yes()) outer.colour = Colour::green;
  if (yes()) outer.perhaps = 0.25;
  if (yes()) outer.words = {text() + "1", text() + "2"};
  if (yes()) outer.steps = {0, 7, 1'000'000};
  if (yes()) outer.pair = {number(), -0.0};
  if (yes()) outer.point = Vector::Constant(static_cast<Eigen::Index>(random() % 4), number());
  if (yes()) outer.options = {{text(), number()}, {text(), text()}};
  if (yes()) outer.inner.length = 3e-300;
  for (auto left = random() % 3; left > 0; --left)
    outer.list.push_back({1.0 / static_cast<double>(3 + left)});
  if (yes()) outer.others["x-1"] = {7};
  return outer;
}

TEST(Fields, AreReadBackAsTheyWereWritten) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 2000; ++k) {
    const Outer outer = any_outer(random);
    const std::string text = toml_of_fields(outer);
    const auto again = fields_from<Outer>(text, "again");
    visit_fields(
        [&](const Field& field, const auto& read, const auto& written) {
          EXPECT_TRUE(are_equal(read, written)) << field.key << '\n' << text;
        },
        again, outer);
    EXPECT_EQ(toml_of_fields(again), text);
  }
  EXPECT_EQ(toml_of_fields(Outer{}), "name = \"a\"\n\n[inner]\nlength = 0.5\n") << "as usual";
  const auto with_unit = fields_from<Outer>("name = \"a\"\ninner = {length = \"3 mm\"}", "text");
  EXPECT_EQ(with_unit.inner.length, 3e-3);
}

TEST(Fields, AreRefusedWithPlaceValueAndWhatIsAllowed) {
  const auto read = [](const std::string& text) { return fields_from<Outer>(text, "my.toml"); };
  const auto read_line = [&](const std::string& line) { return read("name = \"a\"\n" + line); };
  expect_refusals(
      read_line,
      {{"number = true", "my.toml: number = true: must be a number"},
       {"count = 10", "my.toml: count = 10: must be a whole number from 1 to 9"},
       {"count = 1.0", "my.toml: count = 1.0: must be a whole number from 1 to 9"},
       {"flag = 1", "my.toml: flag = 1: must be true or false"},
       {"colour = \"blue\"", "my.toml: colour = 'blue': must be \"red\" or \"green\""},
       {"perhaps = 1", "my.toml: perhaps = 1: must be a number from 0 to 1, but not 1"},
       {"words = []", "my.toml: words = []: must be a list of one or more"},
       {"words = [\"a\", \"\"]", "my.toml: words = '': must be a text that is not empty"},
       {"words = [\"a\", \"a\"]", "must be a list without repetitions"},
       {"steps = [2, 1]", "my.toml: steps = [ 2, 1 ]: must be rising"},
       {"pair = [1]", "my.toml: pair = [ 1 ]: must be a list of 2"},
       {"point = 1", "my.toml: point = 1: must be a list of numbers"},
       {"options = {a = nan}", "my.toml, options: a = nan: must be a finite number or a text"},
       {"inner = 1", "my.toml: inner = 1: must be a table"},
       {"inner = {width = 1}", "my.toml, inner: there is no key width; allowed: length"},
       {"inner = {length = \"1 kg\"}", "my.toml, inner: length = '1 kg': must be"},
       {"inner = {length = \"-1 mm\"}", "length = '-1 mm': must be a finite number > 0"},
       {"list = []", "must be one or more tables [[list]]"},
       {"[[list]]\n[[list]]\nlength = 0", "my.toml:3, list 2: length = 0: must be"},
       {"other = 1", "my.toml: other = 1: must be a table"}});
  expect_refusals(read, {{"count = 1", "my.toml: name is missing"},
                         {"name = \"a b\"", "name = 'a b': must be " + names_in_words}});
}

TEST(Fields, RangesSayWhatTheyContain) {
  EXPECT_TRUE(contains(Range{}, quiet_nan));
  EXPECT_FALSE(contains(whole_number(0), quiet_nan));
  EXPECT_FALSE(contains(whole_number(0), 1.5));
  EXPECT_TRUE(contains(whole_number(0), 0));
  EXPECT_FALSE(contains(positive_number, 0));
  EXPECT_FALSE(contains(positive_number, infinity));
  EXPECT_EQ(in_words(whole_number(1, 1e12)), "a whole number from 1 to 1000000000000");
  EXPECT_EQ(in_words({.least = 0, .most = 1, .without_least = true}),
            "a number from 0 to 1, but not 0");
}

}  // namespace
}  // namespace ricochet
