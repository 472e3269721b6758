#include "src/experiment/plan.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "ricochet/error.h"

namespace ricochet {
namespace {

using testing::HasSubstr;

using Random = std::mt19937_64;

std::int64_t whole(Random& random, std::int64_t least, std::int64_t most) {
  return least + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(most - least + 1));
}

/// Texts with what a writer of TOML must escape.
std::string any_text(Random& random) {
  std::string text = "x";
  for (auto left = random() % 6; left > 0; --left) {
    text +=
        std::vector<std::string>{"*", "\"", "\\", "'", "\n", "\t", "é", "[a-c]", "?"}[random() % 9];
  }
  return text;
}

template <class Draw>
auto any_list(Random& random, std::size_t least, const Draw& draw) {
  std::vector<decltype(draw())> list;
  for (std::size_t left = least + random() % 4; left > 0; --left) {
    const auto entry = draw();
    if (std::find(list.begin(), list.end(), entry) == list.end()) list.push_back(entry);
  }
  return list;
}

PlanPart any_part(Random& random) {
  const auto text = [&] { return any_text(random); };
  const auto level = [&] { return random() % 5 == 0 ? 0 : static_cast<double>(random()) * 1e-19; };
  const auto yes = [&] { return random() % 2 == 0; };
  PlanPart part;
  static int parts = 0;
  if (yes()) part.name = "part-" + std::to_string(++parts);
  part.problems = any_list(random, 1, text);
  if (yes()) {
    const auto number_or_text = [&]() -> OptionValue {
      if (yes()) return level();
      return text();
    };
    part.machines.around = any_text(random);
    for (const char* key : {"fidelity", "friction", "restitution"}) {
      if (yes()) part.machines.levels[key] = any_list(random, 1, number_or_text);
    }
  }
  if (part.machines.around.empty() && yes()) {
    part.drawn_machines = static_cast<int>(whole(random, 1, 9));
  }
  if (yes()) part.least_variables = whole(random, 1, 100);
  part.most_variables = yes() ? part.least_variables : whole(random, 100, 1'000'000'000'000);
  if (yes()) part.constrained = yes();
  part.solvers = any_list(random, 1, text);
  if (yes()) part.formulations = any_list(random, 1, text);
  if (yes()) part.smoothings = any_list(random, 0, [&] { return level() + 1e-9; });
  if (part.drawn_machines == 0 && part.machines.around.empty()) part.relocated_optimum = yes();
  if (!part.relocated_optimum && yes()) part.perturbations = any_list(random, 1, text);
  if (yes()) {
    part.gradient_prices = any_list(random, 1, [&]() -> std::string {
      return random() % 3 == 0   ? "n"
             : random() % 2 == 0 ? "measured"
                                 : std::to_string(random() % 99);
    });
  }
  part.budgets = any_list(random, 1, [&] { return whole(random, 1, 1'000'000'000'000); });
  std::sort(part.budgets.begin(), part.budgets.end());
  if (yes()) part.instances = static_cast<int>(whole(random, 1, 1'000'000));
  if (yes()) part.seeds = static_cast<int>(whole(random, 1, 1'000'000));
  return part;
}

VariedSolver any_solver(Random& random) {
  VariedSolver solver{fmt::format("solver-{}", random() % 1000), any_text(random), {}};
  for (auto left = random() % 3; left > 0; --left) {
    OptionValue& value = solver.options[any_text(random)];
    value = static_cast<double>(random()) * 1e-19 - 0.5;
    if (random() % 2 == 0) value = any_text(random);
  }
  return solver;
}

TEST(Plan, IsReadBackFromItsText) {
  Random random(1);
  for (int k = 0; k < 1000; ++k) {
    Plan plan;
    plan.name = any_text(random);
    if (random() % 2 == 0) plan.first_instance = static_cast<int>(whole(random, 1, 1'000'000));
    plan.limits = {static_cast<double>(random()) * 1e-15 + 1e-9, 1 + static_cast<double>(random())};
    for (auto left = random() % 3; left > 0; --left) plan.solvers.push_back(any_solver(random));
    for (auto left = 1 + random() % 3; left > 0; --left) plan.parts.push_back(any_part(random));
    const std::string text = text_of(plan);
    const Plan again = plan_from(text, "again");
    EXPECT_EQ(again.name, plan.name);
    EXPECT_EQ(again.first_instance, plan.first_instance);
    EXPECT_EQ(again.limits.seconds, plan.limits.seconds);
    EXPECT_EQ(again.limits.megabytes, plan.limits.megabytes);
    EXPECT_EQ(again.solvers, plan.solvers) << text;
    EXPECT_EQ(again.parts, plan.parts) << text;
    EXPECT_EQ(text_of(again), text);
  }
}

TEST(Plan, HasWhatItsDocumentationSaysWhereNothingIsNamed) {
  const Plan plan = plan_from("[[part]]\nproblems = \"a\"\nsolvers = \"b\"\nbudgets = 7", "least");
  PlanPart part;
  part.problems = {"a"};
  part.solvers = {"b"};
  part.budgets = {7};
  EXPECT_EQ(plan.parts, std::vector{part});
  EXPECT_EQ(plan.limits.seconds, Limits().seconds);
  EXPECT_EQ(plan.limits.megabytes, Limits().megabytes);
}

/// What is said of a text, which must be refused.
std::string complaint(const std::string& text) {
  try {
    static_cast<void>(plan_from(text, "my.toml"));
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing, though it is wrong: " + text;
}

const std::string least = "[[part]]\nproblems = [\"a\"]\nsolvers = [\"b\"]\nbudgets = [7]\n";

TEST(Plan, RefusesAValueWithPlaceValueAndRange) {
  const std::string place = "my.toml:1, part 1";
  struct Wrong {
    std::string line, place, value, allowed;
  };
  for (const Wrong& wrong : std::vector<Wrong>{
           {"instances = 0", place, "instances = 0", "a whole number from 1 to 1000000"},
           {"instances = 1.5", place, "instances = 1.5", "a whole number from 1 to 1000000"},
           {"instances = [1]", place, "instances = ", "a whole number from 1 to 1000000"},
           {"seeds = 1000001", place, "seeds = 1000001", "a whole number from 1 to 1000000"},
           {"seeds = \"1\"", place, "seeds = ", "a whole number from 1 to 1000000"},
           {"variables = []", place, "variables = []", "a number, or [least, most]"},
           {"variables = [1, 2, 3]", place, "variables = ", "a number, or [least, most]"},
           {"variables = [3, 2]", place, "variables = [ 3, 2 ]", "must be rising"},
           {"variables = 0", place, "variables = 0", "a whole number from 1"},
           {"constrained = 1", place, "constrained = 1", "true or false"},
           {"formulations = []", place, "formulations = []", "a list of one or more"},
           {"formulations = [1]", place, "formulations = 1", "a text"},
           {"formulations = [\"\"]", place, "formulations = ", "a text that is not empty"},
           {"perturbations = []", place, "perturbations = []", "a list of one or more"},
           {"perturbations = [\"a\", \"a\"]", place, "perturbations = ", "without repetitions"},
           {"smoothings = [0.0]", place, "smoothings = 0.0", "a finite number > 0"},
           {"smoothings = [-1]", place, "smoothings = -1", "a finite number > 0"},
           {"smoothings = [nan]", place, "smoothings = nan", "a finite number > 0"},
           {"smoothings = [inf]", place, "smoothings = inf", "a finite number > 0"},
           {"smoothings = [true]", place, "smoothings = true", "a finite number > 0"},
           {"gradient_prices = [-1]", place, "gradient_prices = -1", "from 0 to 1000000000"},
           {"gradient_prices = [\"m\"]", place, "gradient_prices = ", "\"n\", \"measured\""},
           {"gradient_prices = [1.5]", place, "gradient_prices = 1.5", "a whole number >= 0"},
           {"gradient_prices = []", place, "gradient_prices = []", "a list of one or more"},
           {"machines = 1", place, "machines = 1", "a table"},
           {"machines = {}", place + ", machines", "around", "is missing"},
           {"machines = {around = 1}", place + ", machines", "around = 1", "a text"},
           {"machines = {around = \"C1\", friction = [true]}", place + ", machines",
            "friction = true", "a finite number or a text"},
           {"machines = {around = \"C1\", friction = []}", place + ", machines", "friction = []",
            "a list of one or more"},
           {"drawn_machines = 0", place, "drawn_machines = 0", "a whole number from 1"},
           {"relocated_optimum = 1", place, "relocated_optimum = 1", "true or false"},
           {"drawn_machines = 1\nmachines = {around = \"C1\"}", place, "drawn_machines = 1",
            "left out where machines are named"},
           {"relocated_optimum = true\nmachines = {around = \"C1\"}", place,
            "relocated_optimum = true", "left out where machines are named or drawn"},
           {"relocated_optimum = true\nperturbations = \"noisy\"", place,
            "perturbations = ", "left out where relocated_optimum is true"},
           {"name = \"../up\"", place, "name = ", "small letters, digits and hyphens"},
           {"seed = 1", place, "there is no key seed", "seeds"}}) {
    const std::string said = complaint(least + wrong.line);
    EXPECT_THAT(said, testing::StartsWith(wrong.place + ": ")) << wrong.line;
    EXPECT_THAT(said, HasSubstr(wrong.value)) << wrong.line;
    EXPECT_THAT(said, HasSubstr(wrong.allowed)) << wrong.line;
  }
}

TEST(Plan, RefusesASolverThatIsNone) {
  const std::string whole = "[[solver]]\nname = \"mine\"\nof = \"efwa\"\n";
  const auto said = [](const std::string& solver) { return complaint(solver + "\n" + least); };
  EXPECT_THAT(said(whole), HasSubstr("my.toml:1, solver 1: options is missing"));
  EXPECT_THAT(said(whole + "options = 3"), HasSubstr("options = 3: must be a table"));
  EXPECT_THAT(said(whole + "options = { sparks = true }"),
              HasSubstr("solver 1, options: sparks = true: must be a finite number or a text"));
  EXPECT_THAT(said(whole + "options = { sparks = inf }"), HasSubstr("must be a finite number"));
  EXPECT_THAT(said(whole + "option = { sparks = 1 }"), HasSubstr("there is no key option"));
  EXPECT_THAT(said("[[solver]]\nof = \"efwa\"\noptions = {}"), HasSubstr("name is missing"));
  for (const std::string name : {"", "a b", "a/b", "=cmd|x", "@SUM(1)", "\\u001b[31m", "\\u202e"}) {
    EXPECT_THAT(said("[[solver]]\nname = \"" + name + "\"\nof = \"efwa\"\noptions = {}"),
                HasSubstr(": must be 1 to 60 letters, digits and the characters - _ . +"))
        << name;
  }
  EXPECT_THAT(said("[solver]"), HasSubstr("one or more tables [[solver]]"));
}

/// A plan with this scene and one part around it.
std::string plan_with(const std::string& scene) {
  return "name = \"mine\"\n[[scene]]\n" + scene +
         "\n[[part]]\nproblems = [\"*\"]\nmachines = { around = \"mine\" }\n"
         "solvers = [\"*\"]\nbudgets = [1]\n";
}

std::string complaint_about_scene(const std::string& scene) {
  try {
    plan_from(plan_with(scene), "a plan");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Plan, KeepsTheTextOfASceneAndReadsItBack) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "plan_scene";
  std::filesystem::create_directories(folder);
  const std::string text = "# \"mine\" \\ \t\n[scene]\nmass = 1.0\n";
  std::ofstream(folder / "machine.toml") << text;
  std::ofstream(folder / "plan.toml")
      << plan_with("name = \"mine\"\nfile = \"" + (folder / "machine.toml").string() + "\"");
  const Plan plan = read_plan((folder / "plan.toml").string());
  ASSERT_EQ(plan.scenes.size(), 1U);
  EXPECT_EQ(plan.scenes[0], (PlanScene{"mine", text}));
  EXPECT_EQ(plan.parts[0].machines.around, "mine");
  std::filesystem::remove_all(folder);
  const Plan again = plan_from(text_of(plan), "a store");
  EXPECT_EQ(again.scenes, plan.scenes);
  EXPECT_EQ(text_of(again), text_of(plan));
  EXPECT_THROW(read_plan((folder / "plan.toml").string()), InputError);
}

TEST(Plan, RefusesASceneThatIsNone) {
  EXPECT_THAT(
      complaint_about_scene("name = \"mine\"\nfile = \"machine.toml\""),
      HasSubstr("scene 1: file = 'machine.toml': must be left out: a stored plan has the text"));
  EXPECT_THAT(complaint_about_scene("name = \"mine\""),
              HasSubstr("must have one of file and text"));
  EXPECT_THAT(complaint_about_scene("text = \"\""), HasSubstr("name is missing"));
  EXPECT_THAT(complaint_about_scene("name = \"a b\"\ntext = \"\""), HasSubstr("name = 'a b'"));
  EXPECT_THAT(complaint_about_scene("name = \"mine\"\ntext = \"[\""), HasSubstr("not valid TOML"));
  EXPECT_THAT(complaint_about_scene("name = \"mine\"\ntext = \"\"\nfil = 1"), HasSubstr("fil"));
  EXPECT_THAT(complaint_about_scene(
                  "name = \"mine\"\ntext = \"\"\n[[scene]]\nname = \"mine\"\ntext = \"\""),
              HasSubstr("unlike that of another scene"));
}

TEST(Plan, RefusesPartsOfOneName) {
  const std::string named = least + "name = \"wide\"\n";
  EXPECT_EQ(plan_from(named + least, "my.toml").parts.front().name, "wide");
  EXPECT_THAT(complaint(named + named),
              HasSubstr("part 2: name = 'wide': must be unlike that of another part"));
}

TEST(Plan, HasThePartsOfThosePlansThatItIncludesAfterItsOwn) {
  const auto other = [](const std::string& name) {
    return plan_from("name = \"" + name + "\"\n" + least + "name = \"" + name + "\"\n", name);
  };
  const Plan plan = plan_from("include = [\"b\", \"a\"]\n" + least, "my.toml", other);
  ASSERT_EQ(plan.parts.size(), 3U);
  EXPECT_EQ(plan.parts[1].name, "b");
  EXPECT_EQ(plan.parts[2].name, "a");
  EXPECT_EQ(plan.name, Plan().name);
  EXPECT_EQ(plan_from("include = \"a\"", "my.toml", other).parts.size(), 1U);
  const Plan again = plan_from(text_of(plan), "a store");
  EXPECT_EQ(text_of(again), text_of(plan)) << "a stored plan includes none";
  EXPECT_THAT(complaint("include = [\"a\"]\n" + least),
              HasSubstr("include = [ 'a' ]: must be left out"));
  try {
    plan_from("include = [\"a\", \"b\"]", "my.toml",
              [&](const std::string&) { return other("a"); });
    FAIL() << "two parts of one name";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("part 2: name = 'a': must be unlike that of another part"));
  }
}

TEST(Plan, RefusesBudgetsThatDoNotRise) {
  const std::string frame = "[[part]]\nproblems = \"a\"\nsolvers = \"b\"\nbudgets = ";
  EXPECT_THAT(complaint(frame + "[7, 5]"), HasSubstr("budgets = [ 7, 5 ]: must be rising"));
  EXPECT_THAT(complaint(frame + "[5, 5]"), HasSubstr("without repetitions"));
  EXPECT_THAT(complaint(frame + "[]"), HasSubstr("a list of one or more"));
  EXPECT_THAT(complaint(frame + "0"), HasSubstr("a whole number from 1 to 1000000000000"));
  EXPECT_THAT(complaint(frame + "2e3"), HasSubstr("a whole number"));
}

TEST(Plan, RefusesWhatIsMissingOrNoPlan) {
  EXPECT_THAT(complaint(""), HasSubstr("my.toml: part is missing"));
  EXPECT_THAT(complaint("part = 1"), HasSubstr("one or more tables [[part]]"));
  EXPECT_THAT(complaint("part = []"), HasSubstr("one or more tables [[part]]"));
  EXPECT_THAT(complaint("[part]"), HasSubstr("one or more tables [[part]]"));
  EXPECT_THAT(complaint("name = 1\n" + least), HasSubstr("my.toml: name = 1: must be a text"));
  EXPECT_THAT(complaint("names = 1\n" + least), HasSubstr("there is no key names"));
  EXPECT_THAT(complaint("limits = 1\n" + least), HasSubstr("limits = 1: must be a table"));
  EXPECT_THAT(complaint("limits = {seconds = 0}\n" + least),
              HasSubstr("my.toml, limits: seconds = 0: must be a finite number > 0"));
  EXPECT_THAT(complaint("limits = {minutes = 1}\n" + least), HasSubstr("there is no key minutes"));
  EXPECT_THAT(complaint(least + "[[part]]\nsolvers = \"b\"\nbudgets = 7"),
              HasSubstr("my.toml:5, part 2: problems is missing"));
  for (const std::string key : {"problems", "solvers", "budgets"}) {
    std::string text = least;
    text.replace(text.find(key), key.size(), "# " + key);
    EXPECT_THAT(complaint(text), HasSubstr(key + " is missing"));
  }
  EXPECT_THAT(complaint("[[part"), HasSubstr("my.toml"));
}

TEST(Plan, OfAFileThatIsMissingIsRefused) {
  EXPECT_THROW(read_plan("/nothing/there.toml"), InputError);
}

}  // namespace
}  // namespace ricochet
