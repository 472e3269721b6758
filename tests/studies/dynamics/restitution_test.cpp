#include <gtest/gtest.h>

#include <cmath>

#include "src/studies/dynamics/work.h"

namespace ricochet::studies::dynamics {
namespace {

using carrier_track::ContactLaw;

TEST(Restitution, IsReturnedByTheExactLaw) {
  for (const LawStudy& law : study_laws(8)) {
    if (law.law != ContactLaw::exact_restitution) continue;
    ASSERT_EQ(law.exact.size(), 97U);
    ASSERT_EQ(law.measured.size(), 13U);
    for (const auto& point : law.exact) EXPECT_NEAR(point.returned, point.asked, 1e-8);
    for (const auto& point : law.measured) EXPECT_NEAR(point.returned, point.asked, 1e-8);
  }
}

TEST(Restitution, OfATenthByHuntAndCrossleyIsAboutAHalf) {
  // With D = 1.35, D (1 + e) = ln((1 + D) / (1 - e D)).
  const double e = closed_return(ContactLaw::hunt_crossley, 0.1);
  EXPECT_GT(e, 0.5);
  EXPECT_LT(e, 0.54);
  EXPECT_NEAR(1.35 * (1 + e), std::log(2.35 / (1 - e * 1.35)), 1e-12);
  EXPECT_NEAR(measured_return(ContactLaw::hunt_crossley, 0.1), e, 1e-7);
}

TEST(Restitution, OfHertzIsOneWhateverIsAskedFor) {
  for (const LawStudy& law : study_laws(96)) {
    if (law.law != ContactLaw::hertz) continue;
    for (const auto& point : law.exact) EXPECT_EQ(point.returned, 1);
    EXPECT_EQ(worst_of(law).asked, 0.02);
  }
}

TEST(Restitution, IsMeasuredAsTheRelationHasIt) {
  for (const LawStudy& law : study_laws(24)) {
    EXPECT_LT(largest_measurement_error(law), 1e-7) << law.name;
  }
}

}  // namespace
}  // namespace ricochet::studies::dynamics
