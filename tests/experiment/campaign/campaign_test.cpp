#include "src/experiment/campaign.h"

#include "tests/support/campaigns.h"
#include "tests/support/refusals.h"

namespace ricochet {
namespace {

template <class Member>
std::set<std::string> names(const Campaign& campaign, Member member) {
  std::set<std::string> all;
  for (const PlannedCell& cell : campaign.cells()) all.insert(cell.cell.*member);
  return all;
}

TEST(Campaign, ChoosesProblemsByPatternWhoseBestValueIsKnown) {
  const std::pair<std::string, std::set<std::string>> plans[] = {
      {part_of("\"bowl-*\""), {"bowl-1", "bowl-2", "bowl-8"}},
      {part_of("[\"bowl-[12]\", \"cup-s\"]"), {"bowl-1", "bowl-2", "cup-s"}},
      {part_of("\"*\"", "variables = 2"), {"bowl-2", "cup-2", "cup-smooth", "cup-s"}},
      {part_of("\"*\"", "variables = [2, 8]\nconstrained = false"), {"bowl-2", "bowl-8", "cup-s"}},
      // Penalised, the solver takes them.
      {part_of("\"*\"", "constrained = true"), {"cup-2", "cup-smooth"}},
      // Of a grid in place of the suite's.
      {part_of("\"bowl-*\"", "machines = {around = \"C1\", restitution = [0.25, 0.5]}"),
       {"bowl-C1-0.250000", "bowl-C1-0.500000"}}};
  for (const auto& [plan, chosen] : plans) {
    EXPECT_EQ(names(made_up_campaign(plan), &Cell::problem), chosen) << plan;
  }
}

TEST(Campaign, ChoosesSolversFormulationsAndPerturbationsByPattern) {
  const Campaign campaign =
      made_up_campaign(part_of("\"*\"",
                               "solvers = [\"chance-*\"]\nformulations = [\"*count\"]\n"
                               "perturbations = [\"plain\", \"noisy\"]"));
  EXPECT_THAT(names(campaign, &Cell::solver), ElementsAre("chance-a", "chance-b"));
  EXPECT_THAT(names(campaign, &Cell::formulation), ElementsAre("count", "penalised-count"));
  EXPECT_THAT(names(campaign, &Cell::problem), ElementsAre("cup-s", "cup-smooth"));
  EXPECT_THAT(names(campaign, &Cell::perturbation), ElementsAre("noisy", "plain"));
  EXPECT_THAT(
      names(made_up_campaign(part_of("[\"cup-s\", \"bowl-1\"]", "smoothings = [0.125, 0.5]")),
            &Cell::formulation),
      ElementsAre("count", "original", "surrogate", "surrogate-0.125"))
      << "smoothings of what can be smoothed";
}

TEST(Campaign, HasAGradientAtItsPrice) {
  Catalogue catalogue = made_up_catalogue();
  for (Solver& solver : catalogue.solvers) solver.content = "a user's, which may ask for gradients";
  const Campaign campaign = made_up_campaign(
      part_of("\"bowl-8\"", "gradient_prices = [\"n\", \"measured\", 0, 5]"), catalogue);
  std::vector<std::optional<std::int64_t>> prices;
  for (const PlannedCell& cell : campaign.cells()) prices.push_back(cell.budget.gradient_price);
  EXPECT_THAT(prices, ElementsAre(std::nullopt, 3, 0, 5));
  EXPECT_EQ(campaign.cells()[3].cell.gradient_price, "5");
}

TEST(Campaign, HasARunOnceThatIsTheSameAtSeveralPrices) {
  const std::string plan = part_of("\"bowl-8\"", "gradient_prices = [\"measured\", \"n\", 8]");
  const Campaign values = made_up_campaign(plan);
  ASSERT_EQ(values.cells().size(), 1U) << "it asks for no gradient";
  const PlannedCell& cell = values.cells().front();
  EXPECT_EQ(cell.cell.gradient_price, "n");
  EXPECT_EQ(cell.budget.gradient_price, std::nullopt);
  EXPECT_THAT(cell.gradient_prices, ElementsAre("measured", "n", "8"));
  EXPECT_THAT(cell.parts, ElementsAre(0));
  Catalogue catalogue = made_up_catalogue();
  for (Solver& solver : catalogue.solvers) {
    solver.capabilities.derivatives = Capabilities::Order::gradient;
  }
  for (Problem& problem : catalogue.families[0].problems) {
    problem.differentiate = [](const Vector&) { return Derivatives(); };
  }
  const Campaign gradients = made_up_campaign(plan, catalogue);
  ASSERT_EQ(gradients.cells().size(), 2U) << "8 is n";
  EXPECT_THAT(gradients.cells()[0].gradient_prices, ElementsAre("measured"));
  EXPECT_THAT(gradients.cells()[1].gradient_prices, ElementsAre("n", "8"));
}

TEST(Campaign, SpendsABudgetForEachVariableAndCountsIt) {
  const Campaign campaign = made_up_campaign(
      part_of("[\"bowl-1\", \"bowl-8\"]", "budgets = [10, 20]\ninstances = 3\nseeds = 2"));
  ASSERT_EQ(campaign.cells().size(), 4U);
  EXPECT_EQ(campaign.cells()[3].budget.evaluations, 160);
  EXPECT_EQ(campaign.runs(), 4 * 6);
  EXPECT_EQ(campaign.work(), 6.0 * (10 + 20 + 8 * (80 + 160))) << "a simulation for each variable";
}

TEST(Campaign, HasACellOnceThatSeveralPartsAskFor) {
  const Campaign campaign = made_up_campaign(part_of("\"bowl-[12]\"", "instances = 5") +
                                             part_of("\"bowl-[28]\"", "instances = 2\nseeds = 3"));
  ASSERT_EQ(campaign.cells().size(), 3U);
  const PlannedCell& both = campaign.cells()[1];
  EXPECT_EQ(std::tuple(both.cell.problem, both.instances, both.seeds), std::tuple("bowl-2", 5, 3));
  EXPECT_THAT(both.parts, ElementsAre(0, 1));
  EXPECT_EQ(campaign.runs(), 5 + 15 + 6);
}

TEST(Campaign, RelocatesTheOptimumInWhatIsShownAsItIsJudged) {
  const Campaign campaign = made_up_campaign(
      part_of("[\"cup-s\", \"bowl-1\"]", "relocated_optimum = true\ninstances = 2"));
  EXPECT_THAT(names(campaign, &Cell::formulation), ElementsAre("count", "original"));
  EXPECT_THAT(names(campaign, &Cell::perturbation),
              ElementsAre("optimum-at-lower-end", "optimum-at-upper-end", "optimum-in-middle"));
  EXPECT_EQ(campaign.runs(), 2 * 3 * 2);
  EXPECT_FALSE(place_named("plain"));
}

/// A solver with options of its own.
std::string varied(const std::string& name, const std::string& of) {
  return "[[solver]]\nname = \"" + name + "\"\nof = \"" + of + "\"\noptions = { strength = 3 }\n";
}

TEST(Campaign, TakesSolversOfTheUsersOwnOrWithOptionsOfTheirOwn) {
  const Campaign own = made_up_campaign(part_of("\"bowl-1\"", "solvers = [\"./mine\", \"luck\"]") +
                                        part_of("\"bowl-2\"", "solvers = \"./mine\""));
  EXPECT_THAT(names(own, &Cell::solver), ElementsAre("luck", "mine"));
  EXPECT_EQ(own.solvers().size(), 2U);
  const Campaign with_options = made_up_campaign(
      varied("mine-1", "luck") + part_of("\"bowl-1\"", "solvers = [\"mine-*\", \"luck\"]"));
  EXPECT_THAT(names(with_options, &Cell::solver), ElementsAre("luck", "mine-1"));
  EXPECT_THAT(with_options.description().plan, HasSubstr("\"strength\" = 3"));
}

TEST(Campaign, RefusesWithItsPlaceWhatCannotBeChosen) {
  const auto read = [](const std::string& plan) { return made_up_campaign(plan); };
  const std::string first = part_of("\"bowl-1\"");
  const auto with = [](const std::string& rest) { return part_of("\"bowl-1\"", rest); };
  const auto around = [&](const std::string& machines) {
    return first + part_of("\"bowl-*\"", "machines = {around = " + machines + "}");
  };
  const auto solvers = [&](const std::string& list) { return with("solvers = " + list); };
  const std::string place = "part 2, machines: ";
  const std::string words = R"(: must be "impact", "compliant", "planar")";
  const std::string taken = "there is another solver of its name";
  const std::string mine = solvers("[\"mine-*\", \"luck\"]");
  expect_refusals(
      read,
      {{part_of("[\"bowl-1\", \"bwl-2\"]"),
        "part 1, problems bwl-2: nothing fits; did you mean bowl-2"},
       {part_of("\"bowl-open\""), "nothing fits"},
       {first + solvers("[\"lucky\"]"), "part 2, solvers lucky: nothing fits"},
       {with("perturbations = \"noise\""), "part 1, perturbations noise: nothing fits"},
       {around("\"C1\", frictoin = 0.5"),
        place + "there is no key frictoin; did you mean friction?"},
       {around("\"C1\", friction = -1"), place + "friction = -1: must be numbers >= 0"},
       {around("\"C1\", friction = [0.5, \"much\"]"),
        place + "friction = much: must be numbers >= 0"},
       {around("\"C1\", fidelity = \"auto\""), place + "fidelity = auto" + words},
       {around("\"C1\", fidelity = [\"impact\", 1]"), place + "fidelity = 1" + words},
       {around("\"C99\""), place + "there is no case C99"},
       {with("variables = 2"), "part 1: none of"},
       {part_of("\"cup-2\"", "formulations = \"original\""), "part 1: none"},
       {with("formulations = \"surrogate\""), "part 1: none"},
       {varied("mine-1", "fate") + mine, "solver mine-1: fate has no options"},
       {varied("luck", "luck") + mine, taken},
       {varied("mine-1", "luck") + varied("mine-1", "luck") + mine, "solver mine-1: " + taken},
       {solvers("[\"./luck\"]"), taken},
       {solvers("[\"./a/mine\", \"./b/mine\"]"), "part 1, solvers ./b/mine: " + taken},
       {solvers("\"./a/mine\"") + part_of("\"bowl-2\"", "solvers = \"./b/mine\""),
        "part 2, solvers ./b/mine: " + taken}});
}

TEST(Campaign, OfTooManyRunsCellsOrMachinesIsRefusedBeforeItIsBuilt) {
  const std::string many = "seeds = 1000000\ninstances = ";
  const std::string first = part_of("\"bowl-1\"", many + "1");
  EXPECT_NO_THROW(made_up_campaign(first));
  std::string levels;
  for (int k = 1; k <= 101; ++k) levels += std::to_string(k) + ",";
  expect_refusals(
      [](const std::string& plan) { return made_up_campaign(plan); },
      {{part_of("\"*\"", "seeds = 1000000"), "part 1: 1.2e+08 runs: must be at most 5000000"},
       {first + part_of("\"bowl-2\"", many + "5"), "all parts: 6e+06 runs"},  // each would do
       {part_of("\"bowl-1\"", "instances = 200001"),
        "part 1: 2e+05 instances of problems: must be at most 200000; so many would take about "
        "2.8 GB of memory and 4.6 s before the first run"},
       {part_of("\"*\"", "drawn_machines = 1000000"), "must be at most 10000"},
       {part_of("\"*\"", "machines = {around = \"C1\", friction = [" + levels +
                             "], restitution = [" + levels + "]}"),
        "1.02e+04 combinations: must be at most 10000"}});
}

TEST(Campaign, DescribesWhatItsRunsAreJudgedBy) {
  using testing::Field;
  const CampaignDescription description =
      made_up_campaign(part_of("[\"bowl-2\", \"cup-2\"]")).description();
  EXPECT_THAT(
      description.problems,
      ElementsAre(
          AllOf(Field(&StoredProblem::family, "bowl"), Field(&StoredProblem::variables, 2)),
          AllOf(Field(&StoredProblem::family, "cup"), Field(&StoredProblem::constraints, 1))));
  EXPECT_THAT(description.solvers, ElementsAre(Field(&StoredSolver::version, "1")));
  EXPECT_EQ(description.plan, text_of(plan_from(description.plan, "again")));
}

/// The square of the distance from 1/2.
Problem centred() {
  Problem problem = bowl("centred", 2);
  problem.best_point = Vector::Constant(2, 0.5);
  problem.true_values = [](const Vector& x) {
    return TrueValues{(x.array() - 0.5).square().sum(), 0};
  };
  return with_idle_knob(problem);
}

TEST(RelocatedOptimum, DiffersInWhereTheBestPointLies) {
  const Problem problem = centred();
  using Place = OptimumPlace;
  for (const auto& [place, lower, upper] : {std::tuple(Place::lower_end, 0.5, 1.0),
                                            {Place::middle, 0.0, 1.0},
                                            {Place::upper_end, 0.0, 0.5}}) {
    const Problem moved = relocated(problem, place, 1);
    EXPECT_EQ(moved.lower, Vector::Constant(2, lower));
    EXPECT_EQ(moved.upper, Vector::Constant(2, upper));
    EXPECT_EQ(true_values_at(moved, *moved.best_point).objective, 0);
    EXPECT_TRUE((moved.start.array() >= lower && moved.start.array() <= upper).all());
    EXPECT_EQ(moved.smoothed(0.125).lower, moved.lower);
    EXPECT_EQ(relocated(problem, place, 1).start, moved.start);
    EXPECT_NE(relocated(problem, place, 2).start, moved.start) << "drawn for every number";
  }
  Problem aside = centred();
  aside.best_point = Vector::Constant(2, 0.25);
  EXPECT_EQ(relocated(aside, Place::middle, 1).lower, Vector::Zero(2));
  EXPECT_EQ(relocated(aside, Place::middle, 1).upper, Vector::Constant(2, 0.5));
}

TEST(RelocatedOptimum, NeedsABestPointAtNoEnd) {
  Problem problem = centred();
  EXPECT_TRUE(can_be_relocated(problem));
  for (const double end : {0.0, 1.0}) {
    (*problem.best_point)[1] = end;
    EXPECT_FALSE(can_be_relocated(problem));
  }
  problem.best_point.reset();
  EXPECT_FALSE(can_be_relocated(problem));
}

}  // namespace
}  // namespace ricochet
