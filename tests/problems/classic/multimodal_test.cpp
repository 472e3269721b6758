#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "problems/classic/functions.h"

namespace ricochet::classic {
namespace {

using std::numbers::e;
using std::numbers::pi;

double at(const Problem& problem, const Vector& x) {
  return problem.evaluate(x).objective;
}

TEST(Multimodal, HasTheValuesWorkedByHand) {
  EXPECT_NEAR(at(rastrigin(2), Vector{{1, -2}}), 5, 1e-12);
  EXPECT_NEAR(at(rastrigin(2), Vector{{0.5, 0}}), 20.25, 1e-12);
  EXPECT_NEAR(at(ackley(2), Vector{{1, 1}}), 20 - 20 * std::exp(-0.2), 1e-12);
  EXPECT_NEAR(at(ackley(2), Vector{{0.5, 0.5}}), 20 - 20 * std::exp(-0.1) + e - 1 / e, 1e-12);
  EXPECT_NEAR(at(griewank(2), Vector{{pi, 0}}), 2 + pi * pi / 4000, 1e-12);
  EXPECT_NEAR(at(griewank(2), Vector{{0, pi * std::sqrt(2.0)}}), 2 + pi * pi / 2000, 1e-12);
  const double wave = std::sin(1.0);
  EXPECT_NEAR(at(levy(2), Vector{{5, 1}}), 1 + 10 * wave * wave, 1e-12);  // w = (2, 1)
  EXPECT_NEAR(at(levy(2), Vector{{1, 2}}), 2.0 / 16, 1e-12);              // w = (1, 5/4)
  EXPECT_NEAR(at(levy(2), Vector{{2, 1}}),
              0.5 + (1 + 10 * std::pow(std::sin(1.25 * pi + 1), 2)) / 16, 1e-12);  // w = (5/4, 1)
  EXPECT_EQ(at(styblinski_tang(2), Vector{{1, -1}}), -5 - 10);
  EXPECT_NEAR(at(schwefel_2_26(2), Vector{{pi * pi / 4, 0}}), -pi * pi / 4, 1e-12);
}

TEST(Multimodal, HasThePublishedOptima) {
  EXPECT_NEAR(*styblinski_tang(1).best_known, -39.16599, 3e-4);  // Styblinski and Tang (1990)
  EXPECT_NEAR((*styblinski_tang(1).best_point)[0], -2.903534, 1e-6);
  EXPECT_NEAR(*schwefel_2_26(1).best_known, -418.982887, 1e-6);  // Schwefel (1981)
  EXPECT_NEAR((*schwefel_2_26(1).best_point)[0], 420.968746, 1e-6);
  EXPECT_NEAR(*hartmann_3().best_known, -3.86278, 5e-6);  // Dixon and Szegoe (1978)
  EXPECT_NEAR(*hartmann_6().best_known, -3.32237, 5e-6);
  EXPECT_NEAR(*shekel().best_known, -10.5364, 5e-5);
}

TEST(Multimodal, HasAFiniteSlopeWhereAFormulaHasNone) {
  EXPECT_EQ(ackley(2).differentiate(Vector::Zero(2)).gradient, Vector::Zero(2));
  EXPECT_EQ(schwefel_2_26(2).differentiate(Vector::Zero(2)).gradient, Vector::Zero(2));
}

TEST(Multimodal, IsStationaryAtItsBestPoint) {
  for (const Problem& problem : {rastrigin(3), griewank(3), levy(3), styblinski_tang(3),
                                 schwefel_2_26(3), hartmann_3(), hartmann_6(), shekel()}) {
    EXPECT_LT(problem.differentiate(*problem.best_point).gradient.norm(), 1e-12) << problem.name;
  }
}

}  // namespace
}  // namespace ricochet::classic
