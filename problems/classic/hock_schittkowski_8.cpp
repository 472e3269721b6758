#include <array>
#include <cmath>
#include <numbers>

#include "problems/classic/hock_schittkowski.h"

namespace ricochet::classic {
namespace {

using std::numbers::sqrt3;

/// Heat exchangers.
Problem hs_106() {
  return from_formulas(
      hock_schittkowski(
          106, "", Vector{{100, 1000, 1000, 10, 10, 10, 10, 10}},
          Vector{{1e4, 1e4, 1e4, 1000, 1000, 1000, 1000, 1000}},
          Vector{{5000, 5000, 5000, 200, 350, 150, 225, 425}},
          {7049.248020528674,
           Vector{{579.3066844253551, 1359.9706680516558, 5109.970668051663, 182.01769958111987,
                   295.60117327793375, 217.9823004188801, 286.41652630318606, 395.6011732779337}},
           "published: 7049.330923, near the minimum; digits by Newton's method"}),
      []<class Scalar>(const Point<Scalar>& x) { return x[0] + x[1] + x[2]; },
      []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 6>{0.0025 * (x[3] + x[5]) - 1.0,
                                     0.0025 * (x[4] + x[6] - x[3]) - 1.0,
                                     0.01 * (x[7] - x[4]) - 1.0,
                                     833.33252 * x[3] + 100.0 * x[0] - 83333.333 - x[0] * x[5],
                                     1250.0 * x[4] + x[1] * x[3] - x[1] * x[6] - 1250.0 * x[3],
                                     1250000.0 + x[2] * x[4] - 2500.0 * x[4] - x[2] * x[7]};
      });
}

/// The largest hexagon of unit diameter, without the sign conditions that would keep it convex.
Problem hs_108() {
  Vector lower = Vector::Constant(9, -10);
  lower[8] = 0;
  const double high = sqrt3 / 2;
  return from_formulas(
      hock_schittkowski(108, "", lower, Vector::Constant(9, 10), Vector::Ones(9),
                        {-high, Vector{{high, 0.5, 0, 1, high, 0.5, 0, 1, 0}},
                         "closed form, one of many; published: -0.8660254038"}),
      []<class Scalar>(const Point<Scalar>& x) {
        return -0.5 *
               (x[0] * x[3] - x[1] * x[2] + x[2] * x[8] - x[4] * x[8] + x[4] * x[7] - x[5] * x[6]);
      },
      []<class Scalar>(const Point<Scalar>& x) {
        const auto beyond_1 = [](const Scalar& a, const Scalar& b) {
          return Scalar(a * a + b * b - 1.0);
        };
        return std::array<Scalar, 13>{beyond_1(x[2], x[3]),
                                      x[8] * x[8] - 1.0,
                                      beyond_1(x[4], x[5]),
                                      beyond_1(x[0], x[1] - x[8]),
                                      beyond_1(x[0] - x[4], x[1] - x[5]),
                                      beyond_1(x[0] - x[6], x[1] - x[7]),
                                      beyond_1(x[2] - x[4], x[3] - x[5]),
                                      beyond_1(x[2] - x[6], x[3] - x[7]),
                                      beyond_1(x[6], x[7] - x[8]),
                                      x[1] * x[2] - x[0] * x[3],
                                      -x[2] * x[8],
                                      x[4] * x[8],
                                      x[5] * x[6] - x[4] * x[7]};
      });
}

Problem hs_110() {
  return from_formula(
      hock_schittkowski(110, "", Vector::Constant(10, 2.001), Vector::Constant(10, 9.999),
                        Vector::Constant(10, 9),
                        {-45.77846970744628, Vector::Constant(10, 9.350265833069384),
                         "published: -45.77846971; digits by Newton's method"}),
      []<class Scalar>(const Point<Scalar>& x) {
        using std::log, std::pow;
        Scalar sum(0.0);
        for (Eigen::Index i = 0; i < x.size(); ++i) {
          sum += square(log(x[i] - 2.0)) + square(log(10.0 - x[i]));
        }
        return Scalar(sum - pow(x.prod(), 0.2));
      });
}

/// The free energies of the substances of problems 111 and 112.
constexpr std::array<double, 10> energy = {-6.089,  -17.164, -34.054, -5.914,  -24.721,
                                           -14.986, -24.1,   -10.708, -26.662, -22.179};

/// The free energy of these amounts; an amount of 0 contributes 0.
template <class Scalar>
Scalar free_energy(const Point<Scalar>& amount) {
  using std::log;
  const Scalar all = amount.sum();
  Scalar sum(0.0);
  for (std::size_t i = 0; i < energy.size(); ++i) {
    const Scalar& x = amount[static_cast<Eigen::Index>(i)];
    sum += x * (energy[i] + log(x / all));
  }
  return sum;
}

constexpr const char* of_the_equilibrium =
    "published: -47.707579, near the minimum, and later -47.76109026; digits by Newton's method";

/// The excess of atoms of each kind.
template <class Scalar>
std::array<Scalar, 3> atoms_too_many(const Point<Scalar>& x) {
  return {x[0] + 2.0 * x[1] + 2.0 * x[2] + x[5] + x[9] - 2.0, x[3] + 2.0 * x[4] + x[5] + x[6] - 1.0,
          x[2] + x[6] + x[7] + 2.0 * x[8] + x[9] - 1.0};
}

template <class Scalar>
Point<Scalar> exponentials(const Point<Scalar>& x) {
  using std::exp;
  Point<Scalar> result(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) result[i] = exp(x[i]);
  return result;
}

/// Problem 112 in logarithmic variables.
Problem hs_111() {
  return with_equations(
      from_formulas(
          hock_schittkowski(111, "", Vector::Constant(10, -100), Vector::Constant(10, 100),
                            Vector::Constant(10, -2.3),
                            {-47.761090859365879,
                             Vector{{-3.2023115885512174, -1.9123665970809844, -0.24442674775038301,
                                     -6.5611772716583765, -0.72309796329530451, -7.2742322801881443,
                                     -3.5972374223277823, -4.0203167306908494, -3.2883768813602603,
                                     -2.334371739220618}},
                             of_the_equilibrium}),
          []<class Scalar>(const Point<Scalar>& x) { return free_energy<Scalar>(exponentials(x)); },
          []<class Scalar>(const Point<Scalar>& x) {
            return atoms_too_many<Scalar>(exponentials(x));
          }),
      3);
}

/// Chemical equilibrium.
Problem hs_112() {
  return with_equations(
      from_formulas(
          hock_schittkowski(
              112, "", Vector::Constant(10, 1e-6), Vector::Constant(10, 10),
              Vector::Constant(10, 0.1),
              {-47.761090859365865,
               Vector{{0.040668087355690115, 0.14773035434082166, 0.7831533540092345,
                       0.0014142198090301209, 0.48524664869927286, 0.0006931720784210653,
                       0.027399310714003255, 0.017947279584925372, 0.03731436591303015,
                       0.09687132386577664}},
               of_the_equilibrium}),
          []<class Scalar>(const Point<Scalar>& x) { return free_energy<Scalar>(x); },
          []<class Scalar>(const Point<Scalar>& x) { return atoms_too_many<Scalar>(x); }),
      3);
}

Problem hs_113() {
  return from_formulas(
      hock_schittkowski(
          113, "Asaadi, Charalambous, Wong", Vector::Constant(10, -20), Vector::Constant(10, 20),
          Vector{{2, 3, 5, 5, 1, 2, 7, 3, 6, 10}},
          {24.30620906817979,
           Vector{{2.1719963712554549, 2.3636829736972809, 8.7739257384768496, 5.0959844879484528,
                   0.9906547649638594, 1.4305739789363159, 1.3216442081617028, 9.8287258078863218,
                   8.2800916700983453, 8.375926663921323}},
           "published: 24.3062091; digits by Newton's method", true}),
      []<class Scalar>(const Point<Scalar>& x) {
        return square(x[0]) + square(x[1]) + x[0] * x[1] - 14.0 * x[0] - 16.0 * x[1] +
               square(x[2] - 10.0) + 4.0 * square(x[3] - 5.0) + square(x[4] - 3.0) +
               2.0 * square(x[5] - 1.0) + 5.0 * square(x[6]) + 7.0 * square(x[7] - 11.0) +
               2.0 * square(x[8] - 10.0) + square(x[9] - 7.0) + 45.0;
      },
      []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 8>{
            4.0 * x[0] + 5.0 * x[1] - 3.0 * x[6] + 9.0 * x[7] - 105.0,
            10.0 * x[0] - 8.0 * x[1] - 17.0 * x[6] + 2.0 * x[7],
            -8.0 * x[0] + 2.0 * x[1] + 5.0 * x[8] - 2.0 * x[9] - 12.0,
            3.0 * square(x[0] - 2.0) + 4.0 * square(x[1] - 3.0) + 2.0 * square(x[2]) - 7.0 * x[3] -
                120.0,
            5.0 * square(x[0]) + 8.0 * x[1] + square(x[2] - 6.0) - 2.0 * x[3] - 40.0,
            0.5 * square(x[0] - 8.0) + 2.0 * square(x[1] - 4.0) + 3.0 * square(x[4]) - x[5] - 30.0,
            square(x[0]) + 2.0 * square(x[1] - 2.0) - 2.0 * x[0] * x[1] + 14.0 * x[4] - 6.0 * x[5],
            -3.0 * x[0] + 6.0 * x[1] + 12.0 * square(x[8] - 8.0) - 7.0 * x[9]};
      });
}

/// Production of three goods over five periods: each may change little between periods, and their
/// total demand in each period is given.
Problem hs_118() {
  Vector lower = Vector::Zero(15);
  lower.head(3) << 8, 43, 3;
  Vector upper(15), start(15);
  upper << 21, 57, 16, 90, 120, 60, 90, 120, 60, 90, 120, 60, 90, 120, 60;
  start << 20, 55, 15, 20, 60, 20, 20, 60, 20, 20, 60, 20, 20, 60, 20;
  Vector best(15);
  best << 8, 49, 3, 1, 56, 0, 1, 63, 6, 3, 70, 12, 5, 77, 18;
  return from_formulas(
      hock_schittkowski(118, "", lower, upper, start, {664.82045, best, in_closed_form}),
      []<class Scalar>(const Point<Scalar>& x) {
        Scalar cost(0.0);
        for (Eigen::Index k = 0; k < 15; k += 3) {
          cost += 2.3 * x[k] + 1e-4 * x[k] * x[k] + 1.7 * x[k + 1] + 1e-4 * x[k + 1] * x[k + 1] +
                  2.2 * x[k + 2] + 1.5e-4 * x[k + 2] * x[k + 2];
        }
        return cost;
      },
      []<class Scalar>(const Point<Scalar>& x) {
        constexpr std::array<double, 3> most = {6, 7, 6};
        constexpr std::array<double, 5> wanted = {60, 50, 70, 85, 100};
        Point<Scalar> result(29);
        for (Eigen::Index good = 0; good < 3; ++good) {
          for (Eigen::Index k = 0; k < 4; ++k) {
            const Scalar change = x[3 * (k + 1) + good] - x[3 * k + good];
            result[4 * good + k] = -change - 7.0;
            result[12 + 4 * good + k] = change - most[static_cast<std::size_t>(good)];
          }
        }
        for (Eigen::Index k = 0; k < 5; ++k) {
          result[24 + k] =
              wanted[static_cast<std::size_t>(k)] - x[3 * k] - x[3 * k + 1] - x[3 * k + 2];
        }
        return result;
      });
}

Problem hs_119() {
  // The pairs i < j, numbered from 1, whose products occur, beside all squares.
  using Pairs = std::array<std::array<Eigen::Index, 2>, 30>;
  constexpr Pairs pairs = {{{1, 4},  {1, 7},  {1, 8},   {1, 16},  {2, 3},   {2, 7},
                            {2, 10}, {3, 7},  {3, 9},   {3, 10},  {3, 14},  {4, 7},
                            {4, 11}, {4, 15}, {5, 6},   {5, 10},  {5, 12},  {5, 16},
                            {6, 8},  {6, 15}, {7, 11},  {7, 13},  {8, 10},  {8, 15},
                            {9, 12}, {9, 16}, {10, 14}, {11, 13}, {12, 14}, {13, 14}}};
  Matrix left(8, 8);
  left << 0.22, 0.2, 0.19, 0.25, 0.15, 0.11, 0.12, 0.13,  //
      -1.46, 0, -1.3, 1.82, -1.15, 0, 0.8, 0,             //
      1.29, -0.89, 0, 0, -1.16, -0.96, 0, -0.49,          //
      -1.1, -1.06, 0.95, -0.54, 0, -1.78, -0.41, 0,       //
      0, 0, 0, -1.43, 1.51, 0.59, -0.33, -0.43,           //
      0, -1.72, -0.33, 0, 1.62, 1.24, 0.21, -0.26,        //
      1.12, 0, 0, 0.31, 0, 0, 1.12, 0,                    //
      0, 0.45, 0.26, -1.1, 0.58, 0, -1.03, 0.1;
  const Vector sums{{2.5, 1.1, -3.1, -3.5, 1.3, 2.1, 2.3, -1.5}};
  return with_equations(
      from_formulas(
          hock_schittkowski(119, "", Vector::Zero(16), Vector::Constant(16, 5),
                            Vector::Constant(16, 10),
                            {244.8996975168009,
                             Vector{{0.03984735141112241, 0.7919831556883807, 0.2028703302510363,
                                     0.844357916365675, 1.269906452866503, 0.934738707824643,
                                     1.6819619692469192, 0.15530087738956894, 1.567870333551801, 0,
                                     0, 0, 0.6602040660869546, 0, 0.6742559268682823, 0}},
                             "published: 244.899698; digits by Newton's method"}),
          [pairs]<class Scalar>(const Point<Scalar>& x) {
            const auto term = [&x](Eigen::Index i) { return Scalar(x[i] * x[i] + x[i] + 1.0); };
            Scalar sum(0.0);
            for (Eigen::Index i = 0; i < 16; ++i) sum += square(term(i));
            for (const auto& [i, j] : pairs) sum += term(i - 1) * term(j - 1);
            return sum;
          },
          [left, sums]<class Scalar>(const Point<Scalar>& x) {
            Point<Scalar> result(8);
            for (Eigen::Index i = 0; i < 8; ++i) {
              result[i] = x[i + 8] - sums[i];
              for (Eigen::Index j = 0; j < 8; ++j) result[i] += left(i, j) * x[j];
            }
            result[6] -= 0.36 * x[8];
            return result;
          }),
      8);
}

}  // namespace

std::vector<Problem> hock_schittkowski_8() {
  return {hs_106(), hs_108(), hs_110(), hs_111(), hs_112(), hs_113(), hs_118(), hs_119()};
}

}  // namespace ricochet::classic
