#include <toml++/toml.h>

#include "ricochet/evaluator.h"
#include "src/studies/suite/suite.h"
#include "tests/support/campaigns.h"
#include "tests/support/files.h"
#include "tests/support/refusals.h"

namespace ricochet::studies {
namespace {

TEST(Catalogue, ChargesAGradientWhatItWasMeasuredToTakeWhereAPlanSaysSo) {
  const Campaign campaign = made_up_campaign(
      part_of(R"(["profile-wear-16-C4", "top-speed-C1", "hs-71"])",
              "solvers = \"nlopt-slsqp\"\nformulations = [\"original\", \"surrogate\"]\n"
              "gradient_prices = [\"measured\", \"n\"]\nbudgets = 100"),
      whole_catalogue());
  std::map<std::string, std::int64_t> measured;
  for (const PlannedCell& cell : campaign.cells()) {
    const Problem problem = campaign.problems()[cell.problem].formulated(cell.formulation);
    Evaluator evaluator(problem, cell.budget);
    EXPECT_TRUE(evaluator.derivatives(problem.start));
    const std::int64_t charged = evaluator.ledger().charged - 1;  // beside the value
    if (cell.cell.gradient_price == "measured") {
      measured[cell.cell.problem] = charged;
    } else {
      EXPECT_EQ(charged, problem.dimension());
    }
  }
  // A gradient of one variable costs one evaluation at both prices.
  EXPECT_THAT(measured, ElementsAre(FieldsAre("hs-71", 1), FieldsAre("profile-wear-16-C4", 2)));
}

/// The number of problems and families that README and docs/benchmark-method.md name; pathological
/// problems are counted apart.
TEST(Catalogue, HasAsManyProblemsAsTheDocumentsSay) {
  std::size_t problems = 0, families = 0, small = 0;
  for (const Family& family : suite_families()) {
    const Problem& first = family.problems.front();
    if (first.hazardous || first.held_out) continue;
    ++families;
    problems += family.problems.size();
    small += static_cast<std::size_t>(std::ranges::count_if(
        family.problems, [](const Problem& problem) { return problem.dimension() <= 100; }));
  }
  const auto says = [](const char* file, const std::string& sentence) {
    std::string text = text_of(fs::path(RICOCHET_SOURCE) / file);
    std::ranges::replace(text, '\n', ' ');
    EXPECT_THAT(text, HasSubstr(sentence)) << file;
  };
  says("README.md", fmt::format("with problems of the literature, {} in all,", problems));
  says("docs/benchmark-method.md",
       fmt::format("ricochet has {} problems in {} families", problems, families));
  says("docs/benchmark-method.md", fmt::format("`list problems` has all {}.", problems));
  says("docs/benchmark-method.md", fmt::format("They are not among the {}:", problems));
  says("docs/benchmark-method.md", fmt::format("takes the {} of up to 100 variables", small));
}

/// An ordinary plan must not hang, and an archive's plan of all problems keeps its meaning.
TEST(Catalogue, LeavesPathologicalProblemsToPlansThatNameThem) {
  const auto chosen = [](const std::string& problems) {
    const Campaign campaign = made_up_campaign(
        part_of(problems, "solvers = [\"random-search\", \"nlopt-cobyla\"]\ninstances = 1"),
        whole_catalogue());
    int pathological = 0;
    for (const Problem& problem : campaign.problems()) pathological += problem.hazardous ? 1 : 0;
    return std::pair(pathological, std::ssize(campaign.problems()) - pathological);
  };
  EXPECT_EQ(chosen("\"pathological-*\""), std::pair(9, std::ptrdiff_t{0}));
  EXPECT_EQ(chosen("[\"*-throws\", \"classic-b*\"]"), std::pair(0, std::ptrdiff_t{3}));
}

TEST(Catalogue, NamesThePlaceOfAMachineThatItDoesNotKnow) {
  expect_refusals(
      [](const std::string& machines) {
        return made_up_campaign(
            part_of("\"*\"", "solvers = \"scan\"\nmachines = {around = " + machines + "}"),
            whole_catalogue());
      },
      {{"\"C1\", frictoin = 0.5",
        "part 1, machines: there is no key frictoin; did you mean friction?"},
       {"\"C1\", friction = -1", "part 1, machines: friction = -1: must be"},
       {"\"C1\", fidelity = \"auto\"", "part 1, machines: fidelity = auto"},
       {"\"C1\", restitution = 1.5", "part 1, machines: C1-r1.5"},
       {"\"C99\"", "part 1, machines: C99"}});
}

/// The text of a family, or of the one that it is like; "" if neither has it.
std::string family_text(const toml::table& texts, const std::string& family, const char* key) {
  const auto own = texts[family][key].value<std::string>();
  const auto like = texts[family]["like"].value<std::string>();
  return own ? *own : like ? family_text(texts, *like, key) : "";
}

/// What the page of a family says agrees with its problems.
TEST(FamilyTexts, SayWhatEveryFamilyAsks) {
  const toml::table texts =
      toml::parse_file(RICOCHET_SOURCE "/src/analysis/comparison/families.toml");
  for (const Family& family : suite_families()) {
    for (const char* key : {"title", "asks", "formula", "instances", "users"})
      EXPECT_GT(family_text(texts, family.name, key).size(), 10U) << family.name << ' ' << key;
    std::map<const char*, bool> asked;
    for (const Problem& problem : family.problems) {
      for (const Formulation& formulation : problem.formulations()) {
        const Problem p = problem.formulated(formulation);
        asked["constraints"] |= p.constraints > 0;
        asked["surrogate"] |= static_cast<bool>(p.smoothed);
        asked["derivatives"] |= p.differentiate || p.residuals;
      }
    }
    EXPECT_EQ(asked.size(), 3U);
    for (const auto& [key, is_asked] : asked) {
      EXPECT_NE(family_text(texts, family.name, key).empty(), is_asked)
          << family.name << ' ' << key;
    }
  }
}

}  // namespace
}  // namespace ricochet::studies
