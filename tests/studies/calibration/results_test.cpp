#include "src/studies/calibration/results.h"

#include "tests/studies/calibration/some_search.h"
#include "tests/studies/pages.h"
#include "tests/support/golden.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;
using testing::Field;

Results results_of(const Plan& plan) {
  Searches searches(fresh_file(), some_provenance());
  return calibrate(plan, searches);
}

TEST(Results, RankInterpretationsHoldConstantsAndPredict) {
  const Results results = results_of(tiny_plan());
  ASSERT_GE(results.interpretations.size(), 2U + 11 + 5);
  EXPECT_TRUE(std::ranges::is_sorted(results.interpretations, {},
                                     [](const RankedFit& r) { return r.fit.loss; }));
  for (std::size_t i = 1; i < results.frontier.size(); ++i)
    EXPECT_EQ(results.frontier[i].fit.free.size(), results.frontier[i - 1].fit.free.size() - 1);
  for (const RankedFit& r : results.frontier)
    EXPECT_GE(r.appraisal.criterion, results.frontier[results.chosen].appraisal.criterion);
  // The choice, the default interpretation, the best one, and those as free as the default one.
  ASSERT_GE(results.convergence.size(), 3U + 2);
  ASSERT_LE(results.convergence.size(), 3U + 3);
  ASSERT_EQ(results.converged.size(), results.convergence.size());
  EXPECT_EQ(results.convergence[1].fits[0].free, default_interpretation().free);
  for (std::size_t i = 0; i < results.convergence.size(); ++i) {
    const Convergence& one = results.convergence[i];
    EXPECT_EQ(one.evaluations, i >= 3 && one.agrees() && one.evaluations == 3 ? 3 : 4);
    ASSERT_EQ(one.fits.size(), 2U);
    ASSERT_FALSE(results.converged[i].empty());
    EXPECT_EQ(results.converged[i].size(), one.as_good().size());
    for (const RankedFit& r : results.converged[i]) {
      EXPECT_LE(r.fit.loss, 1.01 * best_of(one.fits).loss);
      EXPECT_GE(r.appraisal.criterion, results.converged[i].front().appraisal.criterion);
    }
    EXPECT_GE(results.converged[i].front().appraisal.criterion,
              results.choice().appraisal.criterion);
  }
  EXPECT_EQ(results.predictions.size(), 50U);
  EXPECT_EQ(results.profiles.size(), results.choice().fit.free.size());
}

TEST(Results, SearchEveryInterpretationOnceAsFreeAsTheDefaultOne) {
  Plan plan = tiny_plan();
  const Interpretation weight = {.normal_force = NormalForce::weight};
  const Interpretation seconds = {.window = WindowUnit::seconds};
  const Interpretation crossing = {.transition = Transition::crossing};
  plan.interpretations = {crossing, Interpretation{}, weight, seconds};
  plan.long_searches->interpretations = 100;
  const Results results = results_of(plan);
  const FittedInterpretation& usual = default_interpretation();
  std::vector<Interpretation> of_others;
  for (std::size_t i = 3; i < results.convergence.size(); ++i)
    of_others.push_back(results.convergence[i].fits[0].interpretation);
  ASSERT_GT(of_others.size(), 3U);
  const auto times = [&](const Interpretation& r) { return std::ranges::count(of_others, r); };
  EXPECT_EQ(results.convergence[1].fits[0].interpretation, usual.interpretation);
  EXPECT_EQ(times(usual.interpretation), 0);
  EXPECT_EQ(times(crossing), 0) << "its cases share no scene";
  // At the normal force that the default interpretation holds, the weight is no other
  // interpretation.
  EXPECT_EQ(times(weight) + times(Interpretation{}), 1);
  for (const Convergence& one : results.convergence) {
    const Fit& fit = one.fits[0];
    if (fit.interpretation != seconds || fit.free.size() != usual.free.size()) continue;
    EXPECT_TRUE(contains(fit.free, Unknown::seconds));
  }
  EXPECT_EQ(times(seconds), 1);
}

TEST(Results, OfBriefSearchesStandWhereTheyAgree) {
  // The evaluations of the searches that rank interpretations.
  const auto evaluations_from = [](const std::vector<int>& seeds) {
    Plan plan = tiny_plan();
    plan.interpretations = {Interpretation{}};
    plan.long_searches->seeds = seeds;
    const Results results = results_of(plan);
    std::set<std::int64_t> evaluations;
    for (std::size_t i = 3; i < results.convergence.size(); ++i)
      evaluations.insert(results.convergence[i].evaluations);
    return evaluations;
  };
  EXPECT_EQ(evaluations_from({1, 1}), std::set<std::int64_t>{3});
  EXPECT_EQ(evaluations_from({1, 2}), std::set<std::int64_t>{4});
}

TEST(Convergence, IsThatTheWorstSearchIsNearTheBest) {
  const auto of = [](const std::vector<double>& losses) {
    Convergence one;
    for (const double loss : losses) one.fits.push_back({{}, loss});
    return one;
  };
  EXPECT_TRUE(of({20, 20.1}).agrees());
  EXPECT_FALSE(of({20, 20.3}).agrees());
  EXPECT_EQ(of({20.3, 20, 20.1}).as_good().size(), 2U);
}

RankedFit ranked(const Interpretation& interpretation, std::vector<Unknown> free, double loss) {
  Fit fit{{interpretation, std::move(free), natural_constants()}, loss};
  fit.constants[static_cast<std::size_t>(Unknown::pull)] = 1;
  Appraisal appraisal = appraise(fit, 1.0);
  return {std::move(fit), std::move(appraisal)};
}

/// Results that nobody computed: the page has to stand whatever they say.
Results made_up_results() {
  Results results;
  results.plan.search = some_search(1);
  for (Solver* solver : {&results.plan.search.global, &results.plan.search.least_squares,
                         &results.plan.search.local})
    solver->version = "1";
  const Interpretation other = {.tension = Tension::rotating};
  results.interpretations = {ranked({}, unknowns_of({}), 20),
                             ranked(other, unknowns_of(other), 30)};
  results.frontier = {ranked({}, {Unknown::pull, Unknown::counting_limit, Unknown::phase}, 20),
                      ranked({}, {Unknown::pull, Unknown::counting_limit}, 21)};
  results.chosen = 1;
  results.usual = ranked({.base = Base::spindle}, unknowns_of({}), 29);
  results.plan.long_searches = LongSearches{{some_search(1).global}, {1, 2}, 800, 400, 2};
  for (const RankedFit& r : {results.frontier[1], results.interpretations[0]}) {
    results.convergence.push_back({800, {r.fit, r.fit}});
    results.converged.push_back({r});
  }
  for (const auto& [what, factor] :
       {std::pair(LeftOut::nothing, 1.1), std::pair(LeftOut::machine, 1.2),
        std::pair(LeftOut::restitution, 1.3), std::pair(LeftOut::friction, 1.4)}) {
    for (const Case& c : all_cases()) {
      if (!c.claim.threshold) continue;
      const double paper = *c.claim.threshold;
      results.predictions.push_back({what, c.id, paper, factor * paper});
    }
  }
  results.predictions.back().predicted.reset();
  results.profiles = {{Unknown::pull, 1, 0.5, 2, false, true},
                      {Unknown::counting_limit, 0.01, 0.009, 0.02, false, false}};
  results.frontier[1].appraisal.threshold_error = 0.0456;
  results.convergence[1].fits[1].loss = 24;
  results.converged[0].push_back(results.converged[0][0]);
  results.converged[0][0].appraisal.threshold_error = 0.0123;
  results.converged[0][1].appraisal.threshold_error = 0.234;
  results.converged[0][0].appraisal.criterion = -30;
  results.converged[1][0].appraisal.criterion = -20;
  return results;
}

std::string page_of(const Results& results) {
  return study_page("calibration", findings_of(results)).files.at("summary.md");
}

/// The tables, a row a line, and the charts, with six digits.
std::string data_of(const report::Results& results) {
  const report::Json data = json_of(results);
  std::string text;
  for (const auto& [name, table] : data["tables"].items()) {
    text += name + "\n";
    for (const report::Json& row : table["rows"]) text += row.dump() + "\n";
  }
  for (const auto& [name, chart] : data["charts"].items())
    for (const auto& [key, part] : chart.items()) text += name + " " + key + part.dump() + "\n";
  return text;
}

TEST(Findings, FillThePage) {
  const Results results = made_up_results();
  const std::string page = page_of(results);
  // All errors of a kind but one are equal here, and so are those of every sample of them.
  EXPECT_THAT(
      page,
      HasSubstr(fmt::format(
          "whole machine, a threshold is {:.0f} % off; with all cases of its restitution {:.0f} %",
          100 * std::log(1.2), 100 * std::log(1.3))));
  const report::Results found = findings_of(results);
  expect_golden(page + "\n" + data_of(found), "calibration.md");
  // A threshold that the fit does not give counts as an error of ln 2.
  EXPECT_NEAR((*found.table("left-out"))[3].number("worst"), std::log(2.0), 1e-12);
}

TEST(Findings, LeaveOutWhatOneInterpretationDoesNotHave) {
  Results results = made_up_results();
  results.interpretations.pop_back();
  results.convergence.clear();
  results.converged.clear();
  results.usual = results.choice();
  const std::string page = page_of(results);
  for (const char* part : {"other searches", "the closest is", "Every other command"})
    EXPECT_THAT(page, Not(HasSubstr(part)));
  EXPECT_THAT(page, HasSubstr("constants does the fit need"));
}

TEST(Findings, ChooseOfTheConvergedRowsTheOneWithTheLowestCriterion) {
  Results results = made_up_results();
  EXPECT_EQ(&results.choice(), &results.converged[0][0]);
  results.converged[1][0].appraisal.criterion = -40;
  EXPECT_EQ(&results.choice(), &results.converged[1][0]);
  results.converged.clear();
  EXPECT_EQ(&results.choice(), &results.frontier[1]);
}

}  // namespace
}  // namespace ricochet::studies::calibration
