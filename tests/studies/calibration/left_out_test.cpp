#include "src/studies/calibration/left_out.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <set>

#include "src/studies/calibration/appraisal.h"
#include "src/studies/paper/interpretation.h"
#include "tests/studies/calibration/some_search.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

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

std::optional<double> threshold_of(const Fit& fit, const std::string& id) {
  for (const CaseAppraisal& c : appraise(fit, 0.2).cases) {
    if (c.the_case.id == id) return c.score.threshold;
  }
  throw std::logic_error("no case " + id);
}

TEST(LeftOut, PredictsEveryThresholdByAFitThatDoesNotKnowIt) {
  Searches searches(fresh_file(), some_provenance());
  const Search search = some_search(6);
  const Fit choice{some_parameterisation()};
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
