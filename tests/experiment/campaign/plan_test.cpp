#include "src/experiment/plan.h"

#include "tests/support/files.h"
#include "tests/support/refusals.h"
#include "tests/support/test.h"

namespace ricochet {
namespace {

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

const std::string least = "[[part]]\nproblems = [\"a\"]\nsolvers = [\"b\"]\nbudgets = [7]\n";

Plan my_plan(const std::string& text) {
  return plan_from(text, "my.toml");
}

/// Beside what every field of its kind refuses: see Fields.
TEST(Plan, RefusesAValueOfAPartWithPlaceValueAndRange) {
  const auto read_line = [](const std::string& line) { return my_plan(least + line); };
  const std::string place = "my.toml:1, part 1";
  const std::string up_to_a_million = "must be a whole number from 1 to 1000000";
  const std::string positive = "must be a finite number > 0";
  const std::string a_list = "must be a list of one or more";
  const std::string a_price = "must be \"n\", \"measured\" or a whole number >= 0";
  const std::string around_c1 = "machines = {around = \"C1\"}";
  expect_refusals(
      read_line,
      {{"instances = 0", place + ": instances = 0: " + up_to_a_million},
       {"seeds = 1000001", place + ": seeds = 1000001: " + up_to_a_million},
       {"variables = []", place + ": variables = []: must be a number, or [least, most]"},
       {"variables = [1, 2, 3]", place + ": variables = [ 1, 2, 3 ]: must be a number, or [least"},
       {"variables = [3, 2]", place + ": variables = [ 3, 2 ]: must be rising"},
       {"variables = 0", place + ": variables = 0: must be a whole number from 1"},
       {"formulations = []", place + ": formulations = []: " + a_list},
       {"perturbations = []", place + ": perturbations = []: " + a_list},
       {"perturbations = [\"a\", \"a\"]",
        place + ": perturbations = [ 'a', 'a' ]: must be a list without repetitions"},
       {"smoothings = [0.0]", place + ": smoothings = 0.0: " + positive},
       {"gradient_prices = [-1]", place + ": gradient_prices = -1: must be a whole number from 0 "
                                          "to 1000000000"},
       {"gradient_prices = [\"m\"]", place + ": gradient_prices = 'm': " + a_price},
       {"gradient_prices = [1.5]", place + ": gradient_prices = 1.5: " + a_price},
       {"gradient_prices = []", place + ": gradient_prices = []: " + a_list},
       {"machines = {}", place + ", machines: around is missing"},
       {"machines = {around = 1}", place + ", machines: around = 1: must be a text"},
       {"machines = {around = \"C1\", friction = [true]}",
        place + ", machines: friction = true: must be a finite number or a text"},
       {"machines = {around = \"C1\", friction = []}",
        place + ", machines: friction = []: " + a_list},
       {"drawn_machines = 0", place + ": drawn_machines = 0: must be a whole number from 1"},
       {"drawn_machines = 1\n" + around_c1,
        place + ": drawn_machines = 1: must be left out where machines are named"},
       {"relocated_optimum = true\n" + around_c1,
        place + ": relocated_optimum = true: must be left out where machines are named or drawn"},
       {"relocated_optimum = true\nperturbations = \"noisy\"",
        place + ": perturbations = 'noisy': must be left out where relocated_optimum is true"},
       {"name = \"../up\"", place + ": name = '../up': must be small letters, digits and hyphens"},
       {"seed = 1", place + ": there is no key seed; did you mean seeds"}});
  const auto read_budgets = [](const std::string& budgets) {
    return my_plan("[[part]]\nproblems = \"a\"\nsolvers = \"b\"\nbudgets = " + budgets);
  };
  expect_refusals(read_budgets, {{"[7, 5]", "budgets = [ 7, 5 ]: must be rising"},
                                 {"[5, 5]", "without repetitions"},
                                 {"[]", a_list},
                                 {"0", "a whole number from 1 to 1000000000000"},
                                 {"2e3", "a whole number"}});
}

TEST(Plan, RefusesASolverThatIsNone) {
  const auto read = [](const std::string& solver) { return my_plan(solver + "\n" + least); };
  const std::string whole = "[[solver]]\nname = \"mine\"\nof = \"efwa\"\n";
  expect_refusals(read, {{whole, "my.toml:1, solver 1: options is missing"},
                         {whole + "options = 3", "options = 3: must be a table"},
                         {whole + "options = { sparks = true }",
                          "solver 1, options: sparks = true: must be a finite number or a text"},
                         {whole + "options = { sparks = inf }", "must be a finite number"},
                         {whole + "option = { sparks = 1 }", "there is no key option"},
                         {"[[solver]]\nof = \"efwa\"\noptions = {}", "name is missing"},
                         {"[[solver]]\nname = \"a b\"\nof = \"efwa\"\noptions = {}",
                          ": must be 1 to 60 letters, digits and the characters - _ . +"},
                         {"[solver]", "one or more tables [[solver]]"}});
}

TEST(Plan, RefusesWhatIsMissingOrNoPlan) {
  const std::string no_part = "one or more tables [[part]]";
  const std::string wide = least + "name = \"wide\"\n";
  EXPECT_EQ(my_plan(wide + least).parts.front().name, "wide");
  expect_refusals(
      my_plan,
      {{"", "my.toml: part is missing"},
       {"part = 1", no_part},
       {"part = []", no_part},
       {"[part]", no_part},
       {"[[part", "my.toml"},
       {"name = 1\n" + least, "my.toml: name = 1: must be a text"},
       {"names = 1\n" + least, "there is no key names"},
       {"limits = 1\n" + least, "limits = 1: must be a table"},
       {"limits = {seconds = 0}\n" + least,
        "my.toml, limits: seconds = 0: must be a finite number > 0"},
       {"limits = {minutes = 1}\n" + least, "there is no key minutes"},
       {least + "[[part]]\nsolvers = \"b\"\nbudgets = 7", "my.toml:5, part 2: problems is missing"},
       {"include = [\"a\"]\n" + least, "include = [ 'a' ]: must be left out"},
       {wide + wide, "part 2: name = 'wide': must be unlike that of another part"}});
  for (const std::string key : {"problems", "solvers", "budgets"}) {
    std::string text = least;
    text.replace(text.find(key), key.size(), "# " + key);
    expect_refusals(my_plan, {{text, key + " is missing"}});
  }
  EXPECT_THROW(read_plan("/nothing/there.toml"), InputError);
}

/// A plan with this scene and one part around it.
std::string plan_with(const std::string& scene) {
  return "name = \"mine\"\n[[scene]]\n" + scene +
         "\n[[part]]\nproblems = [\"*\"]\nmachines = { around = \"mine\" }\n"
         "solvers = [\"*\"]\nbudgets = [1]\n";
}

using PlanFile = TemporaryFolder;

TEST_F(PlanFile, KeepsTheTextOfASceneAndReadsItBack) {
  const std::string text = "# \"mine\" \\ \t\n[scene]\nmass = 1.0\n";
  const auto machine = write_file(folder_ / "machine.toml", text);
  const auto file = write_file(folder_ / "plan.toml",
                               plan_with("name = \"mine\"\nfile = \"" + machine.string() + "\""));
  const Plan plan = read_plan(file.string());
  EXPECT_EQ(plan.scenes, (std::vector{PlanScene{"mine", text}}));
  EXPECT_EQ(plan.parts[0].machines.around, "mine");
  const Plan again = plan_from(text_of(plan), "a store");
  EXPECT_EQ(again.scenes, plan.scenes);
  EXPECT_EQ(text_of(again), text_of(plan));
  std::filesystem::remove(machine);
  EXPECT_THROW(read_plan(file.string()), InputError);
}

TEST(Plan, RefusesASceneThatIsNone) {
  const std::string whole = "name = \"mine\"\ntext = \"\"\n";
  expect_refusals([](const std::string& scene) { return my_plan(plan_with(scene)); },
                  {{"name = \"mine\"\nfile = \"machine.toml\"",
                    "scene 1: file = 'machine.toml': must be left out: a stored plan has the text"},
                   {"name = \"mine\"", "must have one of file and text"},
                   {"text = \"\"", "name is missing"},
                   {"name = \"a b\"\ntext = \"\"", "name = 'a b'"},
                   {"name = \"mine\"\ntext = \"[\"", "not valid TOML"},
                   {whole + "fil = 1", "fil"},
                   {whole + "[[scene]]\n" + whole, "unlike that of another scene"}});
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
  const auto always_a = [&](const std::string&) { return other("a"); };
  EXPECT_THAT(
      complaint_of([&] { return plan_from("include = [\"a\", \"b\"]", "my.toml", always_a); }),
      testing::HasSubstr("part 2: name = 'a': must be unlike that of another part"));
}

}  // namespace
}  // namespace ricochet
