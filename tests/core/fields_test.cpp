#include "src/core/fields.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "ricochet/error.h"
#include "src/core/toml_fields.h"

namespace ricochet {
namespace {

using testing::HasSubstr;

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
  if (yes()) outer.number = yes() ? number() : std::numeric_limits<double>::infinity();
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
}

TEST(Fields, ThatAreAsUsualAreNotWritten) {
  EXPECT_EQ(toml_of_fields(Outer{}), "name = \"a\"\n\n[inner]\nlength = 0.5\n");
}

std::string complaint_about_fields(const std::string& text) {
  try {
    fields_from<Outer>(text, "my.toml");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted: " + text;
}

TEST(Fields, AreRefusedWithPlaceValueAndWhatIsAllowed) {
  struct Wrong {
    std::string line, said;
  };
  for (const auto& [line, said] : std::vector<Wrong>{
           {"number = true", "my.toml: number = true: must be a number"},
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
           {"other = 1", "my.toml: other = 1: must be a table"}}) {
    EXPECT_THAT(complaint_about_fields("name = \"a\"\n" + line), HasSubstr(said));
  }
  EXPECT_THAT(complaint_about_fields("count = 1"), HasSubstr("my.toml: name is missing"));
  EXPECT_THAT(complaint_about_fields("name = \"a b\""),
              HasSubstr("name = 'a b': must be " + names_in_words));
}

TEST(Fields, TakeTextsWithUnits) {
  const auto outer = fields_from<Outer>("name = \"a\"\ninner = {length = \"3 mm\"}", "text");
  EXPECT_EQ(outer.inner.length, 3e-3);
}

TEST(Fields, RangesSayWhatTheyContain) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(contains(Range{}, none));
  EXPECT_FALSE(contains(whole_number(0), none));
  EXPECT_FALSE(contains(whole_number(0), 1.5));
  EXPECT_TRUE(contains(whole_number(0), 0));
  EXPECT_FALSE(contains(positive_number, 0));
  EXPECT_FALSE(contains(positive_number, std::numeric_limits<double>::infinity()));
  EXPECT_EQ(in_words(whole_number(1, 1e12)), "a whole number from 1 to 1000000000000");
  EXPECT_EQ(in_words({.least = 0, .most = 1, .without_least = true}),
            "a number from 0 to 1, but not 0");
}

}  // namespace
}  // namespace ricochet
