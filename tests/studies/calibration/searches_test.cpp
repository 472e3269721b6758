#include "src/studies/calibration/searches.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <filesystem>
#include <fstream>

#include "ricochet/error.h"
#include "src/experiment/store.h"
#include "src/studies/paper/loss.h"
#include "tests/studies/calibration/some_search.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;
using testing::HasSubstr;

Fit fit_of(const Fit& start, const Search& search) {
  return Searches(fresh_file(), some_provenance()).fits({start}, search).at(0);
}

TEST(Searches, AreNoWorseThanTheirStartAndTellTheirLoss) {
  const Fit start{far_parameterisation()};
  const Fit found = fit_of(start, some_search(90));
  EXPECT_LT(found.loss, loss(start));
  EXPECT_DOUBLE_EQ(found.loss, loss(found));
  for (std::size_t i = 0; i < unknown_size; ++i) {
    if (contains(start.free, static_cast<Unknown>(i))) {
      EXPECT_GE(found.constants[i], unknown_parameters()[i].lower);
      EXPECT_LE(found.constants[i], unknown_parameters()[i].upper);
    } else {
      EXPECT_EQ(found.constants[i], start.constants[i]) << unknown_parameters()[i].name;
    }
  }
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
              testing::ElementsAre(testing::Field(&StoredSolver::name, ceres_least_squares().name),
                                   testing::Field(&StoredSolver::name, "nlopt-sbplx")));
}

TEST(Searches, FromRandomPointsEndElsewhereWithEverySeed) {
  const auto file = fresh_file();
  const std::vector<Solver> solvers = {some_search(1).global};
  const auto found = Searches(file, some_provenance())
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
  const auto written = std::filesystem::last_write_time(file);
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  Searches again(file, some_provenance());
  const std::vector<Fit> same = again.fits(starts, some_search(6));
  for (std::size_t i = 0; i < starts.size(); ++i) {
    EXPECT_EQ(same[i].constants, found[i].constants);
    EXPECT_EQ(same[i].loss, found[i].loss);
  }
  EXPECT_EQ(std::filesystem::last_write_time(file), written);
  again.fits(starts, some_search(12));
  EXPECT_GT(Store::open(file, Store::For::reading).size(), 3 * 3);
  EXPECT_NE(Store::open(file, Store::For::reading).digest(), digest);
}

std::string complaint_about(const std::filesystem::path& file, const Provenance& provenance,
                            const Search& search) {
  try {
    Searches(file, provenance).fits({{some_parameterisation()}}, search);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(Searches, RefuseRunsOfAnotherProgramOrSolver) {
  const auto file = fresh_file();
  ASSERT_EQ(complaint_about(file, some_provenance(), some_search(6)), "none");
  EXPECT_EQ(complaint_about(file, some_provenance(), some_search(6)), "none");
  EXPECT_THAT(complaint_about(file, {{{"version", "another"}}, {}}, some_search(6)),
              HasSubstr("runs.sqlite: is of another program"));
  Search search = some_search(6);
  search.local.version = "another";
  EXPECT_THAT(complaint_about(file, some_provenance(), search),
              HasSubstr("runs.sqlite: is of another nlopt-sbplx"));
}

TEST(Searches, RefuseAFileOfSomethingElse) {
  const auto file = fresh_file();
  std::ofstream(file) << "mine";
  EXPECT_THAT(complaint_about(file, some_provenance(), some_search(6)), HasSubstr("runs.sqlite"));
  EXPECT_EQ(std::filesystem::file_size(file), 4U);
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

}  // namespace
}  // namespace ricochet::studies::calibration
