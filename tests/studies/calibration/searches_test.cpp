#include "src/studies/calibration/searches.h"

#include <tbb/global_control.h>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/threshold.h"
#include "src/experiment/store.h"
#include "src/studies/calibration/appraisal.h"
#include "src/studies/calibration/left_out.h"
#include "src/studies/paper/loss.h"
#include "tests/studies/calibration/some_search.h"
#include "tests/support/files.h"
#include "tests/support/numbers.h"
#include "tests/support/refusals.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

Fit fit_of(const Fit& start, const Search& search) {
  return Searches(fresh_file(), some_provenance()).fits({start}, search).at(0);
}

/// The runs that a search is made of, one after the other.
TEST(Searches, GoOnFromTheBestPointOfTheirRuns) {
  const Search search = some_search(60);
  Problem problem = calibration_problem(far_parameterisation());
  problem.name += "-seed-1";
  double best = problem.evaluate(problem.start).objective;
  for (const auto& [solver, evaluations] :
       {std::pair(search.global, 40), std::pair(search.least_squares, 10),
        std::pair(search.local, 10)}) {
    const RunRecord record = run(problem, solver, Budget{evaluations}, 0);
    if (record.trace.empty() || record.trace.back().true_values.objective >= best) continue;
    best = record.trace.back().true_values.objective;
    problem.start = record.trace.back().x;
  }
  const Fit found = fit_of({far_parameterisation()}, search);
  EXPECT_EQ(found.loss, best);
  EXPECT_LT(found.loss, loss(far_parameterisation()));
  EXPECT_DOUBLE_EQ(found.loss, loss(found));
  EXPECT_EQ(found.constants, fit_at(far_parameterisation(), problem.start).constants);
}

TEST(Searches, DependOnTheSeedAndOnWhatIsLeftOut) {
  const Fit start{far_parameterisation()};
  Search search = some_search(12);
  const Fit once = fit_of(start, search);
  const Fit without = fit_of({far_parameterisation(), 0, {"C3"}}, search);
  EXPECT_EQ(without.left_out, CaseIds{"C3"});
  EXPECT_DOUBLE_EQ(without.loss, loss(without, {"C3"}));
  search.seed = 2;
  EXPECT_NE(fit_of(start, search).constants, once.constants);
}

TEST(Searches, PolishWithoutTheGlobalSolver) {
  const auto file = fresh_file();
  const Fit start{some_parameterisation()};
  const auto polished = Searches(file, some_provenance()).polished({start}, some_search(6));
  EXPECT_LE(polished.at(0).loss, loss(start));
  const Store store = Store::open(file, Store::For::reading);
  EXPECT_THAT(store.description().solvers,
              ElementsAre(testing::Field(&StoredSolver::name, ceres_least_squares().name),
                          testing::Field(&StoredSolver::name, "nlopt-sbplx")));
}

TEST(Searches, FromRandomPointsEndElsewhereWithEverySeed) {
  const std::vector<Solver> solvers = {some_search(1).global};
  const auto found = Searches(fresh_file(), some_provenance())
                         .from_random_points({far_parameterisation(), some_parameterisation()},
                                             solvers, {1, 2}, 24);
  ASSERT_EQ(found.size(), 2U);
  ASSERT_EQ(found[0].size(), 2U);
  for (const Fit& fit : found[0]) {
    EXPECT_DOUBLE_EQ(fit.loss, loss(fit));
    EXPECT_LT(fit.loss, loss(far_parameterisation()));
  }
  EXPECT_NE(found[0][0].constants, found[0][1].constants);
  const RunRecord record =
      run(calibration_problem(far_parameterisation()), solvers[0], Budget{24}, 2);
  EXPECT_EQ(found[0][1].loss, record.trace.back().true_values.objective);
}

TEST(Searches, AreMadeOnceWhateverIsAskedForMeanwhile) {
  const auto file = fresh_file();
  const std::vector<Fit> starts = {
      {some_parameterisation()}, {far_parameterisation()}, {far_parameterisation()}};
  std::vector<Fit> found;
  {
    Searches searches(file, some_provenance());
    found = searches.fits(starts, some_search(6));
    searches.fits({{far_parameterisation(), 0, {"C3"}}}, some_search(6));
  }
  EXPECT_EQ(found[1].constants, found[2].constants);
  const std::string digest = Store::open(file, Store::For::reading).digest();
  EXPECT_EQ(Store::open(file, Store::For::reading).size(), 3 * 3);
  const auto written = fs::last_write_time(file);
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  Searches again(file, some_provenance());
  const std::vector<Fit> same = again.fits(starts, some_search(6));
  for (std::size_t i = 0; i < starts.size(); ++i) {
    EXPECT_EQ(same[i].constants, found[i].constants);
    EXPECT_EQ(same[i].loss, found[i].loss);
  }
  EXPECT_EQ(fs::last_write_time(file), written);
  again.fits(starts, some_search(12));
  EXPECT_GT(Store::open(file, Store::For::reading).size(), 3 * 3);
  EXPECT_NE(Store::open(file, Store::For::reading).digest(), digest);
}

TEST(Searches, RefuseRunsOfAnotherProgramOrSolverAndAFileOfSomethingElse) {
  const auto file = fresh_file();
  const auto complaint = [&](const Provenance& provenance, const Search& search) {
    return complaint_of(
        [&] { return Searches(file, provenance).fits({{some_parameterisation()}}, search); });
  };
  const Provenance own = some_provenance();
  Search other_solver = some_search(6);
  other_solver.local.version = "another";
  ASSERT_EQ(complaint(own, some_search(6)), "accepted");
  EXPECT_EQ(complaint(own, some_search(6)), "accepted");
  EXPECT_THAT(complaint({{{"version", "another"}}, {}}, some_search(6)),
              HasSubstr("runs.sqlite: is of another program"));
  EXPECT_THAT(complaint(own, other_solver), HasSubstr("runs.sqlite: is of another nlopt-sbplx"));
  fs::remove(file);
  write_file(file, "mine");
  EXPECT_THAT(complaint(own, some_search(6)), HasSubstr("runs.sqlite"));
  EXPECT_EQ(text_of(file), "mine");
}

TEST(Searches, StopAtAProblemThatFails) {
  const auto file = fresh_file();
  Search search = some_search(6);
  search.global.solve = [](Evaluator&, const Vector&, Random&) -> SolverTermination {
    throw std::runtime_error("broken");
  };
  Searches searches(file, some_provenance());
  EXPECT_THROW(searches.fits({{some_parameterisation()}}, search), std::runtime_error);
  EXPECT_EQ(Store::open(file, Store::For::reading).size(), 0);
}

TEST(Appraisal, IsTheScoreOfEveryCase) {
  const FittedInterpretation& fitted = default_interpretation();
  const Appraisal a = appraise(fitted, 0.05);
  ASSERT_EQ(a.cases.size(), 12U);
  double squares = 0;
  int right = 0;
  double purity = 1;
  for (const CaseAppraisal& c : a.cases) {
    const Score expected =
        score(scene_of(c.the_case, fitted.scene), c.the_case.claim, ScanOptions{0.05, 1, 18.0});
    EXPECT_EQ(c.score.threshold, expected.threshold);
    EXPECT_EQ(c.score.quiet_count, expected.quiet_count);
    if (!c.the_case.claim.threshold) continue;
    squares += std::pow(std::log(*expected.threshold / *c.the_case.claim.threshold), 2);
    for (const Example& e : expected.examples) right += e.right ? 1 : 0;
    purity = std::min(purity, *expected.purity);
  }
  EXPECT_NEAR(a.threshold_error, std::sqrt(squares / 10), 1e-12);
  EXPECT_EQ(a.right_examples, right);
  EXPECT_EQ(a.purity, purity);
}

TEST(Appraisal, ScansWhatItCountsOneByOne) {
  for (const char* name :
       {"projected-constant-revolutions", "projected-constant-revolutions-crossing"}) {
    const Interpretation interpretation = find_interpretation(name);
    const Constants& constants = default_interpretation().constants;
    const Case c = find_case("C9");
    const SpeedScan scan = appraise({interpretation, {}, constants}, c, 0.5).scan;
    const Scene scene = scene_of(c, interpretation, constants);
    ASSERT_EQ(scan.counts.size(), 36U);
    for (std::size_t k = 0; k < scan.counts.size(); ++k)
      EXPECT_EQ(scan.counts[k],
                objective(scene_at(scene, interpretation, constants, scan.omega(k)), 0.0))
          << name << " at " << scan.omega(k);
  }
}

TEST(Appraisal, WeighsErrorAgainstConstants) {
  // n ln(s / n) + 2 p + 2 p (p + 1) / (n - p - 1) by hand: n = 20, s = 0.2 and 0.1, p = 6 and 7.
  EXPECT_NEAR(selection_criterion(0.2, 20, 5), 20 * std::log(0.01) + 12 + 84.0 / 13, 1e-12);
  EXPECT_NEAR(selection_criterion(0.1, 20, 6), 20 * std::log(0.005) + 14 + 112.0 / 12, 1e-12);
  EXPECT_EQ(selection_criterion(0.2, 20, 18), infinity);
}

TEST(Appraisal, ProfilesAroundTheFit) {
  Fit fit{some_parameterisation()};
  fit.loss = loss(fit);
  Searches searches(fresh_file(), some_provenance());
  const auto found = profiles(fit, some_search(2), searches);
  ASSERT_EQ(found.size(), 2U);
  for (std::size_t k = 0; k < found.size(); ++k) {
    const Profile& p = found[k];
    const auto i = static_cast<std::size_t>(p.constant);
    EXPECT_NEAR(p.value, fit.constants[i], 1e-9 * std::abs(fit.constants[i]));
    EXPECT_LE(p.lower, p.value);
    EXPECT_GE(p.upper, p.value);
    EXPECT_LT(p.lower, p.upper);
    // Where a side is closed, the loss has risen, however well the other parameter is fitted.
    for (const auto& [end, open] :
         {std::pair(p.lower, p.lower_open), std::pair(p.upper, p.upper_open)}) {
      Fit start = fit;
      start.free.erase(start.free.begin() + static_cast<std::ptrdiff_t>(k));
      start.constants[i] = end;
      EXPECT_EQ(searches.polished({start}, some_search(2)).at(0).loss > fit.loss + 1, !open);
    }
  }
}

/// The paper's table of cases, by hand.
TEST(LeftOut, HasWholeMachinesRestitutionsAndFrictions) {
  EXPECT_TRUE(groups_of(LeftOut::nothing).empty());
  EXPECT_EQ(groups_of(LeftOut::one_case).size(), 10U);
  EXPECT_EQ(groups_of(LeftOut::machine),
            (std::vector<CaseIds>{
                {"C1", "C5", "C9"}, {"C2", "C6", "C10"}, {"C3", "C7"}, {"C4", "C8", "C11"}}));
  EXPECT_EQ(groups_of(LeftOut::restitution),
            (std::vector<CaseIds>{{"C1", "C3", "C5", "C7", "C9"},
                                  {"C2", "C4", "C6", "C8", "C10", "C11"}}));
  EXPECT_EQ(groups_of(LeftOut::friction),
            (std::vector<CaseIds>{{"C1", "C2", "C5", "C6", "C9", "C10"},
                                  {"C3", "C4", "C7", "C8", "C11"}}));
}

TEST(LeftOut, PredictsEveryThresholdByAFitThatDoesNotKnowIt) {
  Searches searches(fresh_file(), some_provenance());
  const Search search = some_search(6);
  const Fit choice{some_parameterisation()};
  const auto threshold_of = [](const Fit& fit, const std::string& id) {
    return appraise(fit, find_case(id), 0.2).score.threshold;
  };
  const auto all = predictions(choice, search, 2, 0.2, searches);
  for (const LeftOut what : all_left_out) {
    std::set<std::string> ids;
    for (const Prediction& p : predictions_without(what, all)) {
      ids.insert(p.case_id);
      EXPECT_EQ(p.paper, find_case(p.case_id).claim.threshold);
      if (what == LeftOut::nothing) {
        EXPECT_EQ(p.predicted, threshold_of(choice, p.case_id));
      }
    }
    EXPECT_EQ(ids.size(), 10U);
  }
  // The better of two searches, from the natural values, that do not know the machine.
  const Fit start{forgotten(choice), 0, {"C3", "C7"}};
  Search second = search;
  second.seed = 2;
  const Fit a = searches.fits({start}, search).at(0), b = searches.fits({start}, second).at(0);
  ASSERT_NE(a.loss, b.loss);
  const auto predicted = predictions_without(LeftOut::machine, all);
  const auto c7 = std::ranges::find(predicted, "C7", &Prediction::case_id);
  EXPECT_EQ(c7->predicted, threshold_of(a.loss < b.loss ? a : b, "C7"));
}

TEST(LeftOut, CountsAMissingPredictionAsAFactorOfTwo) {
  const std::vector<Prediction> all = {{LeftOut::machine, "C1", 9, 8},
                                       {LeftOut::machine, "C2", 2, std::nullopt},
                                       {LeftOut::machine, "C5", 8, 8}};
  const double eight = std::log(8.0 / 9);
  EXPECT_EQ(errors_of(all), (std::vector<double>{eight, std::log(2.0), 0}));
  EXPECT_EQ(errors_by_machine(all),
            (std::vector<std::vector<double>>{{eight, 0}, {std::log(2.0)}}));
}

}  // namespace
}  // namespace ricochet::studies::calibration
