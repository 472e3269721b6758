#include "src/experiment/campaign.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "ricochet/error.h"
#include "tests/experiment/campaign/made_up_campaign.h"

namespace ricochet {
namespace {

using testing::HasSubstr;
using testing::UnorderedElementsAre;

template <class Member>
std::set<std::string> names(const Campaign& campaign, Member member) {
  std::set<std::string> all;
  for (const PlannedCell& cell : campaign.cells()) all.insert(cell.cell.*member);
  return all;
}

TEST(Campaign, ChoosesProblemsByPatternWhoseBestValueIsKnown) {
  const auto problems = [](const std::string& part) {
    return names(campaign_of(part), &Cell::problem);
  };
  EXPECT_THAT(problems(part_of("\"bowl-*\"")), UnorderedElementsAre("bowl-1", "bowl-2", "bowl-8"));
  EXPECT_THAT(problems(part_of("[\"bowl-[12]\", \"cup-s\"]")),
              UnorderedElementsAre("bowl-1", "bowl-2", "cup-s"));
  EXPECT_THAT(problems(part_of("\"*\"", "variables = 2")),
              UnorderedElementsAre("bowl-2", "cup-2", "cup-smooth", "cup-s"));
  EXPECT_THAT(problems(part_of("\"*\"", "variables = [2, 8]\nconstrained = false")),
              UnorderedElementsAre("bowl-2", "bowl-8", "cup-s"));
  EXPECT_THAT(problems(part_of("\"*\"", "constrained = true")),
              UnorderedElementsAre("cup-2", "cup-smooth"))
      << "penalised, the solver takes them";
}

TEST(Campaign, ChoosesSolversFormulationsAndPerturbationsByPattern) {
  const Campaign campaign =
      campaign_of(part_of("\"*\"",
                          "solvers = [\"chance-*\"]\nformulations = [\"*count\"]\nperturbations = "
                          "[\"plain\", \"noisy\"]"));
  EXPECT_THAT(names(campaign, &Cell::solver), UnorderedElementsAre("chance-a", "chance-b"));
  EXPECT_THAT(names(campaign, &Cell::formulation),
              UnorderedElementsAre("count", "penalised-count"));
  EXPECT_THAT(names(campaign, &Cell::problem), UnorderedElementsAre("cup-smooth", "cup-s"));
  EXPECT_THAT(names(campaign, &Cell::perturbation), UnorderedElementsAre("plain", "noisy"));
}

TEST(Campaign, OfTooManyRunsCellsOrMachinesIsRefusedBeforeItIsBuilt) {
  const auto expect_refused = [](const std::string& part, const std::string& reason) {
    EXPECT_THAT([&] { campaign_of(part); }, testing::ThrowsMessage<InputError>(testing::AllOf(
                                                testing::StartsWith("part 1"), HasSubstr(reason))));
  };
  expect_refused(part_of("\"*\"", "seeds = 1000000"), " runs: must be at most 5000000");
  const std::string many = "seeds = 1000000\ninstances = ";
  const std::string first = part_of("\"bowl-1\"", many + "1");
  EXPECT_NO_THROW(campaign_of(first));
  EXPECT_THAT([&] { campaign_of(first + part_of("\"bowl-2\"", many + "5")); },
              testing::ThrowsMessage<InputError>(HasSubstr("all parts: 6e+06 runs")))
      << "each alone would do";
  expect_refused(part_of("\"bowl-1\"", "instances = 200001"),
                 "2e+05 instances of problems: must be at most 200000; so many would take about "
                 "2.8 GB of memory and 4.6 s before the first run");
  expect_refused(part_of("\"*\"", "drawn_machines = 1000000"), "must be at most 10000");
  std::string levels;
  for (int k = 1; k <= 101; ++k) levels += std::to_string(k) + ",";
  expect_refused(part_of("\"*\"", "machines = {around = \"C1\", friction = [" + levels +
                                      "], restitution = [" + levels + "]}"),
                 "1.02e+04 combinations: must be at most 10000");
}

TEST(Campaign, AddsSmoothingsToWhatCanBeSmoothed) {
  const Campaign campaign =
      campaign_of(part_of("[\"cup-s\", \"bowl-1\"]", "smoothings = [0.125, 0.5]"));
  EXPECT_THAT(names(campaign, &Cell::formulation),
              UnorderedElementsAre("original", "count", "surrogate", "surrogate-0.125"));
}

TEST(Campaign, HasAGradientAtItsPrice) {
  Catalogue catalogue = made_up_catalogue();
  for (Solver& solver : catalogue.solvers) solver.content = "a user's, which may ask for gradients";
  const Campaign campaign(
      plan_from(part_of("\"bowl-8\"", "gradient_prices = [\"n\", \"measured\", 0, 5]"), "test"),
      catalogue);
  ASSERT_EQ(campaign.cells().size(), 4U);
  EXPECT_EQ(campaign.cells()[0].budget.gradient_price, std::nullopt);
  EXPECT_EQ(campaign.cells()[1].budget.gradient_price, 3);
  EXPECT_EQ(campaign.cells()[2].budget.gradient_price, 0);
  EXPECT_EQ(campaign.cells()[3].budget.gradient_price, 5);
  EXPECT_EQ(campaign.cells()[3].cell.gradient_price, "5");
}

TEST(Campaign, HasARunOnceThatIsTheSameAtSeveralPrices) {
  const std::string plan = part_of("\"bowl-8\"", "gradient_prices = [\"measured\", \"n\", 8]");
  const Campaign values(plan_from(plan, "test"), made_up_catalogue());
  ASSERT_EQ(values.cells().size(), 1U) << "it asks for no gradient";
  const PlannedCell& cell = values.cells().front();
  EXPECT_EQ(cell.cell.gradient_price, "n");
  EXPECT_EQ(cell.budget.gradient_price, std::nullopt);
  EXPECT_EQ(cell.gradient_prices, (std::vector<std::string>{"measured", "n", "8"}));
  EXPECT_EQ(cell.parts, std::vector<std::size_t>{0});
  Catalogue catalogue = made_up_catalogue();
  for (Solver& solver : catalogue.solvers) {
    solver.capabilities.derivatives = Capabilities::Order::gradient;
  }
  for (Problem& problem : catalogue.families[0].problems) {
    problem.differentiate = [](const Vector&) { return Derivatives(); };
  }
  const Campaign gradients(plan_from(plan, "test"), catalogue);
  ASSERT_EQ(gradients.cells().size(), 2U) << "8 is n";
  EXPECT_EQ(gradients.cells()[0].gradient_prices, std::vector<std::string>{"measured"});
  EXPECT_EQ(gradients.cells()[1].gradient_prices, (std::vector<std::string>{"n", "8"}));
}

TEST(Campaign, SpendsABudgetForEachVariableAndCountsIt) {
  const Campaign campaign = campaign_of(
      part_of("[\"bowl-1\", \"bowl-8\"]", "budgets = [10, 20]\ninstances = 3\nseeds = 2"));
  ASSERT_EQ(campaign.cells().size(), 4U);
  EXPECT_EQ(campaign.cells()[3].budget.evaluations, 160);
  EXPECT_EQ(campaign.runs(), 4 * 6);
  EXPECT_EQ(campaign.work(), 6.0 * (10 + 20 + 8 * (80 + 160))) << "a simulation for each variable";
}

TEST(Campaign, HasACellOnceThatSeveralPartsAskFor) {
  const Campaign campaign = campaign_of(part_of("\"bowl-[12]\"", "instances = 5") +
                                        part_of("\"bowl-[28]\"", "instances = 2\nseeds = 3"));
  ASSERT_EQ(campaign.cells().size(), 3U);
  const PlannedCell& both = campaign.cells()[1];
  EXPECT_EQ(both.cell.problem, "bowl-2");
  EXPECT_EQ(both.parts, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(both.instances, 5);
  EXPECT_EQ(both.seeds, 3);
  EXPECT_EQ(campaign.runs(), 5 + 15 + 6);
}

TEST(Campaign, AsksProblemsOfAGridInPlaceOfTheSuites) {
  const Campaign campaign =
      campaign_of(part_of("\"bowl-*\"", "machines = {around = \"C1\", restitution = [0.25, 0.5]}"));
  EXPECT_THAT(names(campaign, &Cell::problem),
              UnorderedElementsAre("bowl-C1-0.250000", "bowl-C1-0.500000"));
}

TEST(Campaign, RelocatesTheOptimumInWhatIsShownAsItIsJudged) {
  const Campaign campaign =
      campaign_of(part_of("[\"cup-s\", \"bowl-1\"]", "relocated_optimum = true\ninstances = 2"));
  EXPECT_THAT(names(campaign, &Cell::formulation), UnorderedElementsAre("original", "count"));
  EXPECT_THAT(
      names(campaign, &Cell::perturbation),
      UnorderedElementsAre("optimum-at-lower-end", "optimum-in-middle", "optimum-at-upper-end"));
  EXPECT_EQ(campaign.runs(), 2 * 3 * 2);
}

std::string complaint(const std::string& plan) {
  try {
    campaign_of(plan);
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing";
}

TEST(Campaign, RefusesAPatternThatNothingFits) {
  EXPECT_THAT(
      complaint(part_of("[\"bowl-1\", \"bwl-2\"]")),
      testing::AllOf(HasSubstr("part 1, problems bwl-2: nothing fits"), HasSubstr("bowl-2")));
  EXPECT_THAT(complaint(part_of("\"bowl-open\"")), HasSubstr("nothing fits"));
  EXPECT_THAT(complaint(part_of("\"bowl-1\"") + part_of("\"bowl-1\"", "solvers = [\"lucky\"]")),
              HasSubstr("part 2, solvers lucky: nothing fits"));
  EXPECT_THAT(complaint(part_of("\"bowl-1\"", "perturbations = \"noise\"")),
              HasSubstr("part 1, perturbations noise: nothing fits"));
}

TEST(Campaign, RefusesAGridThatIsNotAllowedWithItsPlace) {
  const auto said = [](const std::string& machines) {
    return complaint(part_of("\"bowl-1\"") +
                     part_of("\"bowl-*\"", "machines = {around = " + machines + "}"));
  };
  const std::string place = "part 2, machines: ";
  EXPECT_EQ(said("\"C1\", frictoin = 0.5"),
            place + "there is no key frictoin; did you mean friction?");
  EXPECT_EQ(said("\"C1\", friction = -1"), place + "friction = -1: must be numbers >= 0");
  EXPECT_EQ(said("\"C1\", friction = [0.5, \"much\"]"),
            place + "friction = much: must be numbers >= 0");
  const std::string words = R"(: must be "impact", "compliant", "planar")";
  EXPECT_EQ(said("\"C1\", fidelity = \"auto\""), place + "fidelity = auto" + words);
  EXPECT_EQ(said("\"C1\", fidelity = [\"impact\", 1]"), place + "fidelity = 1" + words);
  EXPECT_EQ(said("\"C99\""), place + "there is no case C99");
}

TEST(Campaign, RefusesAPartOfWhichNothingIsLeft) {
  EXPECT_THAT(complaint(part_of("\"bowl-1\"", "variables = 2")), HasSubstr("part 1: none of"));
  EXPECT_THAT(complaint(part_of("\"cup-2\"", "formulations = \"original\"")),
              HasSubstr("part 1: none"));
  EXPECT_THAT(complaint(part_of("\"bowl-1\"", "formulations = \"surrogate\"")),
              HasSubstr("part 1: none"));
}

TEST(Campaign, TakesSolversOfTheUsersOwn) {
  const Campaign campaign = campaign_of(part_of("\"bowl-1\"", "solvers = [\"./mine\", \"luck\"]") +
                                        part_of("\"bowl-2\"", "solvers = \"./mine\""));
  EXPECT_THAT(names(campaign, &Cell::solver), UnorderedElementsAre("mine", "luck"));
  EXPECT_EQ(campaign.solvers().size(), 2U);
}

TEST(Campaign, TakesSolversWithOptionsOfTheirOwn) {
  const auto solver = [](const std::string& name, const std::string& of) {
    return "[[solver]]\nname = \"" + name + "\"\nof = \"" + of + "\"\noptions = { strength = 3 }\n";
  };
  const std::string part = part_of("\"bowl-1\"", "solvers = [\"mine-*\", \"luck\"]");
  const Campaign campaign = campaign_of(solver("mine-1", "luck") + part);
  EXPECT_THAT(names(campaign, &Cell::solver), UnorderedElementsAre("mine-1", "luck"));
  EXPECT_THAT(campaign.description().plan, HasSubstr("\"strength\" = 3"));
  EXPECT_THAT(complaint(solver("mine-1", "fate") + part),
              HasSubstr("solver mine-1: fate has no options"));
  EXPECT_THAT(complaint(solver("luck", "luck") + part), HasSubstr("there is another solver"));
  EXPECT_THAT(complaint(solver("mine-1", "luck") + solver("mine-1", "luck") + part),
              HasSubstr("solver mine-1: there is another solver of its name"));
}

TEST(Campaign, RefusesTwoSolversOfOneName) {
  const std::string said = "there is another solver of its name";
  EXPECT_THAT(complaint(part_of("\"bowl-1\"", "solvers = [\"./luck\"]")), HasSubstr(said));
  EXPECT_THAT(complaint(part_of("\"bowl-1\"", "solvers = [\"./a/mine\", \"./b/mine\"]")),
              HasSubstr("part 1, solvers ./b/mine: " + said));
  EXPECT_THAT(complaint(part_of("\"bowl-1\"", "solvers = \"./a/mine\"") +
                        part_of("\"bowl-2\"", "solvers = \"./b/mine\"")),
              HasSubstr("part 2, solvers ./b/mine: " + said));
}

TEST(Campaign, DescribesWhatItsRunsAreJudgedBy) {
  const CampaignDescription description =
      campaign_of(part_of("[\"bowl-2\", \"cup-2\"]")).description();
  ASSERT_EQ(description.problems.size(), 2U);
  EXPECT_EQ(description.problems[1].family, "cup");
  EXPECT_EQ(description.problems[1].constraints, 1);
  EXPECT_EQ(description.problems[0].variables, 2);
  ASSERT_EQ(description.solvers.size(), 1U);
  EXPECT_EQ(description.solvers[0].version, "1");
  EXPECT_EQ(description.plan, text_of(plan_from(description.plan, "again")));
}

}  // namespace
}  // namespace ricochet
