#include "src/experiment/plan.h"

#include "tests/support/files.h"
#include "tests/support/refusals.h"

namespace ricochet {
namespace {

using Random = std::mt19937_64;

std::int64_t whole(Random& random, std::int64_t least, std::int64_t most) {
  return least + static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(most - least + 1));
}

/// Texts with what a writer of TOML must escape.
std::string any_text(Random& random) {
  constexpr const char* parts[] = {"*", "\"", "\\", "'", "\n", "\t", "é", "[a-c]", "?"};
  std::string text = "x";
  for (auto left = random() % 6; left > 0; --left) text += parts[random() % std::size(parts)];
  return text;
}

template <class Draw>
auto any_list(Random& random, std::size_t least, const Draw& draw) {
  std::vector<decltype(draw())> list;
  for (std::size_t left = least + random() % 4; left > 0; --left) {
    const auto entry = draw();
    if (std::ranges::find(list, entry) == list.end()) list.push_back(entry);
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
    const auto number_or_text = [&] { return yes() ? OptionValue(level()) : OptionValue(text()); };
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
  const auto price = [&] {
    return yes() ? yes() ? "n" : "measured" : std::to_string(random() % 99);
  };
  if (yes()) part.gradient_prices = any_list(random, 1, price);
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

auto contents(const Plan& plan) {
  return std::tuple(plan.name, plan.first_instance, plan.limits.seconds, plan.limits.megabytes,
                    plan.solvers, plan.scenes, plan.parts);
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
    EXPECT_EQ(contents(again), contents(plan)) << text;
    EXPECT_EQ(text_of(again), text);
  }
}

TEST(Plan, HasWhatItsDocumentationSaysWhereNothingIsNamed) {
  Plan plan;
  plan.parts.emplace_back();
  plan.parts[0].problems = {"a"};
  plan.parts[0].solvers = {"b"};
  plan.parts[0].budgets = {7};
  EXPECT_EQ(contents(plan_from("[[part]]\nproblems = \"a\"\nsolvers = \"b\"\nbudgets = 7", "")),
            contents(plan));
}

const std::string least = "[[part]]\nproblems = [\"a\"]\nsolvers = [\"b\"]\nbudgets = [7]\n";

Plan my_plan(const std::string& text) {
  return plan_from(text, "my.toml");
}

/// Beside what every field of its kind refuses: see Fields.
TEST(Plan, RefusesAValueOfAPartWithPlaceValueAndRange) {
  const std::string a_list = "must be a list of one or more";
  const std::string a_price = "must be \"n\", \"measured\" or a whole number >= 0";
  const std::string around_c1 = "\nmachines = {around = \"C1\"}";
  const std::vector<Refusal<std::string>> refusals = {
      {"instances = 0", ": instances = 0: must be a whole number from 1 to 1000000"},
      {"seeds = 1000001", "must be a whole number from 1 to 1000000"},
      {"variables = []", "must be a number, or [least, most]"},
      {"variables = [1, 2, 3]", ": variables = [ 1, 2, 3 ]: must be a number, or [least, most]"},
      {"variables = [3, 2]", "must be rising"},
      {"variables = 0", "must be a whole number from 1"},
      {"formulations = []", a_list},
      {"perturbations = []", a_list},
      {"perturbations = [\"a\", \"a\"]", "= [ 'a', 'a' ]: must be a list without repetitions"},
      {"smoothings = [0.0]", "= 0.0: must be a finite number > 0"},
      {"gradient_prices = [-1]", "= -1: must be a whole number from 0 to 1000000000"},
      {"gradient_prices = [\"m\"]", "= 'm': " + a_price},
      {"gradient_prices = [1.5]", "= 1.5: " + a_price},
      {"gradient_prices = []", a_list},
      {"machines = {}", ", machines: around is missing"},
      {"machines = {around = 1}", ", machines: around = 1: must be a text"},
      {"machines = {around = \"C1\", friction = [true]}", "must be a finite number or a text"},
      {"machines = {around = \"C1\", friction = []}", ", machines: friction = []: " + a_list},
      {"drawn_machines = 0", "must be a whole number from 1"},
      {"drawn_machines = 1" + around_c1, "must be left out where machines are named"},
      {"relocated_optimum = true" + around_c1,
       "must be left out where machines are named or drawn"},
      {"perturbations = \"noisy\"\nrelocated_optimum = true",
       "'noisy': must be left out where relocated_optimum is true"},
      {"name = \"../up\"", "= '../up': must be small letters, digits and hyphens"},
      {"seed = 1", "there is no key seed; did you mean seeds"}};
  for (const auto& [line, words] : refusals) {
    EXPECT_THAT(complaint_of([&, &line = line] { return my_plan(least + line); }),
                AllOf(StartsWith("my.toml:1, part 1"), HasSubstr(line.substr(0, line.find(' '))),
                      HasSubstr(words)));
  }
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
    expect_refusals(my_plan,
                    {{std::string(least).insert(least.find(key), "# "), key + " is missing"}});
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
  EXPECT_EQ(contents(plan_from(text_of(plan), "a store")), contents(plan));
  fs::remove(machine);
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
  EXPECT_THAT(plan.parts,
              ElementsAre(testing::Field(&PlanPart::name, ""), testing::Field(&PlanPart::name, "b"),
                          testing::Field(&PlanPart::name, "a")));
  EXPECT_EQ(plan.name, Plan().name);
  EXPECT_EQ(plan_from("include = \"a\"", "my.toml", other).parts.size(), 1U);
  EXPECT_EQ(contents(plan_from(text_of(plan), "a store")), contents(plan)) << "it includes none";
  const auto always_a = [&](const std::string&) { return other("a"); };
  expect_refusals(
      [&](const auto& text) { return plan_from(text, "my.toml", always_a); },
      {{"include = [\"a\", \"b\"]", "part 2: name = 'a': must be unlike that of another"}});
}

}  // namespace
}  // namespace ricochet
