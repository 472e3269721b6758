#include "src/studies/calibration/fit.h"

#include <gtest/gtest.h>

#include "src/studies/paper/loss.h"
#include "tests/studies/calibration/some_search.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

TEST(Fit, IsNoWorseThanItsStartAndTellsItsLoss) {
  Parameterisation parameterisation = some_parameterisation();
  parameterisation.held[static_cast<std::size_t>(Unknown::counting_limit)] *= 3;
  const Fit found = fit(parameterisation, some_search(90));
  EXPECT_LT(found.loss, loss(parameterisation.interpretation, parameterisation.held));
  EXPECT_DOUBLE_EQ(found.loss, loss(found.interpretation, found.constants));
  for (std::size_t i = 0; i < unknown_size; ++i) {
    if (static_cast<Unknown>(i) == Unknown::start_velocity ||
        static_cast<Unknown>(i) == Unknown::counting_limit) {
      EXPECT_GE(found.constants[i], unknown_parameters()[i].lower);
      EXPECT_LE(found.constants[i], unknown_parameters()[i].upper);
    } else {
      EXPECT_EQ(found.constants[i], parameterisation.held[i]) << unknown_parameters()[i].name;
    }
  }
}

TEST(Fit, IsTheSameAgainAndAnotherFromAnotherSeed) {
  Search search = some_search(6);
  Parameterisation far = some_parameterisation();
  far.held[static_cast<std::size_t>(Unknown::counting_limit)] = 0.1;
  const Fit once = fit(far, search);
  EXPECT_EQ(fit(far, search).constants, once.constants);
  search.seed = 2;
  EXPECT_NE(fit(far, search).constants, once.constants);
}

TEST(Fit, PolishesWithoutSearching) {
  const Fit polished = polish(some_parameterisation(), some_search(6));
  EXPECT_LE(polished.loss,
            loss(some_parameterisation().interpretation, some_parameterisation().held));
}

TEST(Fit, DoesNotSeeTheCaseLeftOut) {
  const Fit found = fit(some_parameterisation(), some_search(6), {"C3"});
  EXPECT_EQ(found.left_out, CaseIds{"C3"});
  EXPECT_DOUBLE_EQ(found.loss, loss(found.interpretation, found.constants, {"C3"}));
}

}  // namespace
}  // namespace ricochet::studies::calibration
