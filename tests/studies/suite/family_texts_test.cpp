#include <gtest/gtest.h>
#include <toml++/toml.h>

#include <algorithm>
#include <string>

#include "src/studies/suite/suite.h"

namespace ricochet {
namespace {

/// The text of a family, or of the one that it is like; "" if neither has it.
std::string text_of(const toml::table& texts, const std::string& family, const char* key) {
  const auto own = texts[family][key].value<std::string>();
  const auto like = texts[family]["like"].value<std::string>();
  return own ? *own : like ? text_of(texts, *like, key) : "";
}

/// What the page of a family says agrees with its problems.
TEST(FamilyTexts, SayWhatEveryFamilyAsks) {
  const toml::table texts =
      toml::parse_file(RICOCHET_SOURCE "/src/analysis/comparison/families.toml");
  for (const Family& family : suite_families()) {
    for (const char* key : {"title", "asks", "formula", "instances", "users"}) {
      EXPECT_GT(text_of(texts, family.name, key).size(), 10U) << family.name << ' ' << key;
    }
    const auto any_formulation = [&](const auto& of) {
      return std::ranges::any_of(family.problems, [&](const Problem& problem) {
        return std::ranges::any_of(problem.formulations(), [&](const Formulation& formulation) {
          return of(problem.formulated(formulation));
        });
      });
    };
    EXPECT_EQ(text_of(texts, family.name, "constraints").empty(),
              !any_formulation([](const Problem& p) { return p.constraints > 0; }))
        << family.name;
    EXPECT_EQ(text_of(texts, family.name, "surrogate").empty(),
              !any_formulation([](const Problem& p) { return static_cast<bool>(p.smoothed); }))
        << family.name;
    EXPECT_EQ(text_of(texts, family.name, "derivatives").empty(),
              !any_formulation([](const Problem& p) { return p.differentiate || p.residuals; }))
        << family.name;
  }
}

}  // namespace
}  // namespace ricochet
