#include "problems/carrier_track/scene/contact_law.h"

#include "tests/support/test.h"

namespace ricochet::carrier_track {
namespace {

const std::vector<double> restitutions = {1e-3, 0.01, 0.1,   0.3,  0.5,    0.7,
                                          0.89, 0.9,  0.901, 0.97, 0.9999, 1 - 1e-9};

/// How far e is from the root of D (1 + e) = ln((1 + D) / (1 - e D)), as a step of Newton's.
long double distance(long double d, long double e) {
  const long double residual = d * (1 + e) - std::log1p(d) + std::log1p(-e * d);
  const long double slope = d - d / (1 - e * d);
  return residual / slope;
}

TEST(ContactLaw, ExactDissipationAndReturnedRestitutionSolveTheirEquation) {
  const auto exact = [](double e) { return dissipation(ContactLaw::exact_restitution, e); };
  // From the published formulas, computed apart, six digits.
  EXPECT_NEAR(exact(0.1), 9.99816, 5e-6);
  EXPECT_NEAR(exact(0.5), 1.43275, 5e-6);
  EXPECT_NEAR(exact(0.9), 0.166482, 5e-7);
  EXPECT_EQ(exact(1.0), 0.0);
  for (const double e : restitutions) {
    EXPECT_GT(exact(e), 0);
    EXPECT_NEAR(returned_restitution(exact(e)) / e, 1, 1e-14) << e;
  }
  // D = 1/e - ... with an exponentially small rest; D = 3/2 (1 - e) + 3/2 (1 - e)^2 + ... near 1.
  EXPECT_DOUBLE_EQ(exact(1e-3), 1000.0);
  for (const double loss : {0x1p-10, 0x1p-20, 0x1p-30}) {
    EXPECT_NEAR(exact(1 - loss) / (1.5 * loss), 1 + loss, 2 * loss * loss + 1e-15);
  }
  // Towards either end the equation loses its digits.
  for (const double d : {0.05, 0.17, 0.19, 0.21, 0.5, 0.99, 1.0, 1.35, 5.0, 10.0, 30.0}) {
    const double e = returned_restitution(d);
    EXPECT_NEAR(static_cast<double>(distance(d, e)), 0, 1e-13 * e) << d;
  }
  EXPECT_EQ(returned_restitution(0), 1.0);
  EXPECT_NEAR(returned_restitution(1e-8), 1 - 2e-8 / 3, 1e-15);
  EXPECT_DOUBLE_EQ(returned_restitution(1e4), 1e-4);
}

TEST(ContactLaw, PopularLawsReturnAnotherRestitutionThanTheyAreGiven) {
  const auto returned = [](ContactLaw law, double c) {
    return returned_restitution(dissipation(law, c));
  };
  EXPECT_NEAR(returned(ContactLaw::hunt_crossley, 0.1), 0.52, 0.005);
  EXPECT_NEAR(returned(ContactLaw::hunt_crossley, 0.9), 0.909, 5e-4);
  // Three of them are right to first order in 1 - c, where D must be 3/2 (1 - c); the two made for
  // small c are not even that.
  for (const ContactLaw law :
       {ContactLaw::hunt_crossley, ContactLaw::lankarani_nikravesh, ContactLaw::zhiying_qishao}) {
    EXPECT_NEAR(returned(law, 0.99), 0.99, 2e-4);
    EXPECT_GT(std::abs(returned(law, 0.3) - 0.3), 0.01);
  }
  EXPECT_NEAR(1 - returned(ContactLaw::flores, 0.999), 16.0 / 15 * 1e-3, 1e-5);
  EXPECT_NEAR(1 - returned(ContactLaw::gonthier, 0.999), 4.0 / 3 * 1e-3, 1e-5);
  EXPECT_NEAR(returned(ContactLaw::gonthier, 0.1), 0.1, 0.02);
  EXPECT_NEAR(returned(ContactLaw::flores, 0.1), 0.1, 0.04);
  EXPECT_GT(returned(ContactLaw::lankarani_nikravesh, 0.1), 0.6);
}

TEST(ContactLaw, DissipationFollowsThePublishedFormulas) {
  EXPECT_EQ(dissipation(ContactLaw::hertz, 0.3), 0.0);
  EXPECT_DOUBLE_EQ(dissipation(ContactLaw::hunt_crossley, 0.4), 0.9);
  EXPECT_DOUBLE_EQ(dissipation(ContactLaw::lankarani_nikravesh, 0.4), 0.63);
  EXPECT_DOUBLE_EQ(dissipation(ContactLaw::zhiying_qishao, 0.5), 0.5625 * std::exp(1.0));
  EXPECT_DOUBLE_EQ(dissipation(ContactLaw::flores, 0.2), 6.4);
  EXPECT_DOUBLE_EQ(dissipation(ContactLaw::gonthier, 0.5), 1.5);
}

TEST(ContactLaw, PeakPenetrationIsTheIntegralOfMotion) {
  // u du = -(K/m) d^n (1 + D u / v0) dd, so K/m d^(n+1)/(n+1) = v0^2 times the integral over
  // w = 0..1 of w / (1 + D w), here by Simpson's rule.
  for (const double d : {0.0, 0.01, 0.3, 1.5, 10.0}) {
    double sum = 0;
    const int pieces = 2000;
    for (int i = 0; i <= pieces; ++i) {
      const double w = static_cast<double>(i) / pieces;
      const double weight = i == 0 || i == pieces ? 1 : i % 2 == 0 ? 2 : 4;
      sum += weight * w / (1 + d * w) / (3 * pieces);
    }
    for (const double n : {1.0, 1.5, 2.3}) {
      const double depth = peak_penetration(3e7, n, 1.7, 0.4, d);
      EXPECT_NEAR(3e7 / 1.7 * std::pow(depth, n + 1) / (n + 1) / (0.16 * sum), 1, 1e-9);
    }
  }
}

/// The speed at which a free Kelvin-Voigt contact of unit mass and stiffness, which begins at speed
/// 1, is left: found on the closed-form motion.
double left_speed(double z, Release release) {
  const double s = std::sqrt(std::abs(1 - z * z));
  const auto depth = [&](double t) {
    return std::exp(-z * t) * (z == 1 ? t : (z < 1 ? std::sin(s * t) : std::sinh(s * t)) / s);
  };
  const auto speed = [&](double t) {
    return std::exp(-z * t) * (z < 1 ? std::cos(s * t) : std::cosh(s * t)) - z * depth(t);
  };
  const auto contact = [&](double t) {
    return depth(t) + (release == Release::zero_force ? 2 * z * speed(t) : 0);
  };
  double lower = 1e-3;
  while (contact(lower + 1e-3) > 0) lower += 1e-3;
  double upper = lower + 1e-3;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (lower + upper);
    (contact(middle) > 0 ? lower : upper) = middle;
  }
  return -speed(upper);
}

TEST(ContactLaw, KelvinVoigtReturnsWhatItsMotionDoes) {
  for (const Release release : {Release::zero_force, Release::zero_depth}) {
    for (const double z : {0.01, 0.2, 0.7, 0.99, 1.0, 1.01, 2.0}) {
      if (release == Release::zero_depth && z > 0.9) continue;
      EXPECT_NEAR(kelvin_voigt_restitution(z, release), left_speed(z, release), 1e-10) << z;
    }
    for (const double e : restitutions) {
      EXPECT_NEAR(kelvin_voigt_restitution(damping_ratio(e, release), release) / e, 1, 1e-13) << e;
    }
  }
  EXPECT_EQ(kelvin_voigt_restitution(0, Release::zero_force), 1.0);
  EXPECT_EQ(kelvin_voigt_restitution(1.5, Release::zero_depth), 0.0);
  EXPECT_EQ(damping_ratio(1, Release::zero_force), 0.0);
  EXPECT_GT(damping_ratio(0.1, Release::zero_force), 1) << "c = 0.1 needs more than critical";
}

TEST(ContactLaw, RefusesRestitutionsThatNoDampingReturns) {
  for (const double c : {-0.1, 1.1, std::nan("")}) {
    EXPECT_THROW(dissipation(ContactLaw::hunt_crossley, c), std::invalid_argument);
    EXPECT_THROW(damping_ratio(c, Release::zero_force), std::invalid_argument);
  }
  for (const ContactLaw law :
       {ContactLaw::flores, ContactLaw::gonthier, ContactLaw::exact_restitution}) {
    EXPECT_TRUE(needs_restitution(law));
    EXPECT_THROW(dissipation(law, 0), std::invalid_argument);
  }
  EXPECT_FALSE(needs_restitution(ContactLaw::zhiying_qishao));
  EXPECT_TRUE(needs_restitution(ContactLaw::kelvin_voigt));
  EXPECT_THROW(damping_ratio(0, Release::zero_depth), std::invalid_argument);
  EXPECT_THROW(dissipation(ContactLaw::kelvin_voigt, 0.5), std::invalid_argument);
}

}  // namespace
}  // namespace ricochet::carrier_track
