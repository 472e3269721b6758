#include "src/studies/calibration/fit.h"

#include <gtest/gtest.h>

#include "problems/carrier_track/questions/misfit.h"
#include "tests/studies/calibration/some_search.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

TEST(Fit, IsNoWorseThanItsStartAndTellsItsMisfit) {
  Freedom freedom = some_freedom();
  freedom.held[static_cast<std::size_t>(Open::slowest)] *= 3;
  const Fit found = fit(freedom, some_search(90));
  EXPECT_LT(found.misfit, misfit(freedom.reading, freedom.held));
  EXPECT_DOUBLE_EQ(found.misfit, misfit(found.reading, found.constants));
  for (std::size_t i = 0; i < open_size; ++i) {
    if (static_cast<Open>(i) == Open::start_velocity || static_cast<Open>(i) == Open::slowest) {
      EXPECT_GE(found.constants[i], open_constants()[i].lower);
      EXPECT_LE(found.constants[i], open_constants()[i].upper);
    } else {
      EXPECT_EQ(found.constants[i], freedom.held[i]) << open_constants()[i].name;
    }
  }
}

TEST(Fit, IsTheSameAgainAndAnotherFromAnotherSeed) {
  Search search = some_search(6);
  Freedom far = some_freedom();
  far.held[static_cast<std::size_t>(Open::slowest)] = 0.1;
  const Fit once = fit(far, search);
  EXPECT_EQ(fit(far, search).constants, once.constants);
  search.seed = 2;
  EXPECT_NE(fit(far, search).constants, once.constants);
}

TEST(Fit, PolishesWithoutSearching) {
  const Fit polished = polish(some_freedom(), some_search(6));
  EXPECT_LE(polished.misfit, misfit(some_freedom().reading, some_freedom().held));
}

TEST(Fit, DoesNotSeeTheCaseLeftOut) {
  const Fit found = fit(some_freedom(), some_search(6), "C3");
  EXPECT_EQ(found.left_out, "C3");
  EXPECT_DOUBLE_EQ(found.misfit, misfit(found.reading, found.constants, "C3"));
}

}  // namespace
}  // namespace ricochet::studies::calibration
