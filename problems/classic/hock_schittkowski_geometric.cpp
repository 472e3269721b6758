#include <array>
#include <cmath>

#include "problems/classic/hock_schittkowski.h"
#include "problems/classic/hock_schittkowski_statement.h"

namespace ricochet::classic {
namespace {

/// The objective of problems 101 to 103; the last two constraints keep it between 100 and 3000.
template <class Scalar>
Scalar four_terms(const Point<Scalar>& x, double power) {
  using std::pow, std::sqrt;
  return 10.0 * x[0] * x[3] * x[3] * pow(x[6], power) / (x[1] * cubed(x[5])) +
         15.0 * x[2] * x[3] / (x[0] * x[1] * x[1] * x[4] * sqrt(x[6])) +
         20.0 * x[1] * x[5] / (x[0] * x[0] * x[3] * x[4] * x[4]) +
         25.0 * square(x[0] * x[1]) * sqrt(x[4]) * x[6] / (x[2] * x[5] * x[5]);
}

/// The terms of problems 101 to 103 that must be at most 1.
template <class Scalar>
std::array<Scalar, 4> sums_of_terms(const Point<Scalar>& x) {
  using std::cbrt, std::pow, std::sqrt;
  const Scalar quarter = pow(x[6], 0.25);
  const Scalar third = cbrt(x[6]);
  const Scalar half = sqrt(x[6]);
  const Scalar first = 0.5 * sqrt(x[0]) * x[6] / (x[2] * x[5] * x[5]) +
                       0.7 * cubed(x[0]) * x[1] * x[5] * half / (x[2] * x[2]) +
                       0.2 * x[2] * square(cbrt(x[5])) * quarter / (x[1] * sqrt(x[3]));
  const Scalar second = 1.3 * x[1] * x[5] / (sqrt(x[0]) * x[2] * x[4]) +
                        0.8 * x[2] * x[5] * x[5] / (x[3] * x[4]) +
                        3.1 * sqrt(x[1]) * cbrt(x[5]) / (x[0] * x[3] * x[3] * x[4]);
  const Scalar sum = 2.0 * x[0] * x[4] * third / (x[2] * sqrt(x[2]) * x[5]) +
                     0.1 * x[1] * x[4] / (sqrt(x[2] * x[6]) * x[5]) +
                     x[1] * sqrt(x[2]) * x[4] / x[0] +
                     0.65 * x[2] * x[4] * x[6] / (x[1] * x[1] * x[5]);
  const Scalar fourth =
      0.2 * x[1] * sqrt(x[4]) * third / (x[0] * x[0] * x[3]) +
      0.3 * sqrt(x[0]) * x[1] * x[1] * x[2] * cbrt(x[3]) * quarter / square(cbrt(x[4])) +
      0.4 * x[2] * x[4] * half * quarter / (cubed(x[0]) * x[1] * x[1]) +
      0.5 * x[3] * half / (x[2] * x[2]);
  return {first, second, sum, fourth};
}

/// Problems 101 to 103.
Problem geometric(int number, double power, Optimum optimum) {
  Vector lower = Vector::Constant(7, 0.1);
  lower[6] = 0.01;
  return from_formulas(
      hock_schittkowski(number, "", lower, Vector::Constant(7, 10), Vector::Constant(7, 6),
                        std::move(optimum)),
      [power]<class Scalar>(const Point<Scalar>& x) { return four_terms(x, power); },
      [power]<class Scalar>(const Point<Scalar>& x) {
        const std::array<Scalar, 4> sums = sums_of_terms(x);
        const Scalar cost = four_terms(x, power);
        return std::array<Scalar, 6>{sums[0] - 1.0, sums[1] - 1.0, sums[2] - 1.0,
                                     sums[3] - 1.0, 100.0 - cost,  cost - 3000.0};
      });
}

Problem hs_101() {
  return geometric(
      101, -0.25,
      {1809.764765571413,
       Vector{{2.856158555755148, 0.6108230308034505, 2.1508125621644734, 4.712873709241235,
               0.9994875408574648, 1.347507504828332, 0.03165276650277431}},
       "published: 1809.76476; digits by Newton's method"});
}

Problem hs_102() {
  return geometric(
      102, 0.125,
      {911.8805714301099,
       Vector{{3.8962531910702807, 0.8093587601054141, 2.6643859937754897, 4.300912874794019,
               0.8535549352485835, 1.0952874445761025, 0.027310459657719253}},
       "published: 911.880571; digits by Newton's method"});
}

Problem hs_103() {
  return geometric(
      103, 0.5,
      {543.6679584662812,
       Vector{{4.3941045105264065, 0.8544687387974245, 2.843230313950895, 3.3999786676865593,
               0.7229261330073024, 0.870406381804457, 0.024638826327228507}},
       "published: 543.667958; digits by Newton's method"});
}

/// Two reactors.
Problem hs_104() {
  constexpr auto cost = []<class Scalar>(const Point<Scalar>& x) {
    using std::pow;
    return Scalar(0.4 * pow(x[0] / x[6], 0.67) + 0.4 * pow(x[1] / x[7], 0.67) + 10.0 - x[0] - x[1]);
  };
  return from_formulas(
      hock_schittkowski(
          104, "", Vector::Constant(8, 0.1), Vector::Constant(8, 10),
          Vector{{6, 3, 0.4, 0.2, 6, 6, 1, 0.5}},
          {3.951163440103356,
           Vector{{6.465114028369099, 2.23270864798523, 0.6673974912866294, 0.595756422900371,
                   5.932675677909848, 5.527234564976938, 1.0133220089025616, 0.40066822912570316}},
           "published: 3.9511634396; digits by Newton's method"}),
      cost, [cost]<class Scalar>(const Point<Scalar>& x) {
        using std::pow;
        const Scalar spent = cost(x);
        return std::array<Scalar, 6>{0.0588 * x[4] * x[6] + 0.1 * x[0] - 1.0,
                                     0.0588 * x[5] * x[7] + 0.1 * x[0] + 0.1 * x[1] - 1.0,
                                     4.0 * x[2] / x[4] + 2.0 / (pow(x[2], 0.71) * x[4]) +
                                         0.0588 * x[6] / pow(x[2], 1.3) - 1.0,
                                     4.0 * x[3] / x[5] + 2.0 / (pow(x[3], 0.71) * x[5]) +
                                         0.0588 * x[7] / pow(x[3], 1.3) - 1.0,
                                     1.0 - spent,
                                     spent - 4.2};
      });
}

}  // namespace

std::vector<Problem> hock_schittkowski_geometric() {
  return {hs_101(), hs_102(), hs_103(), hs_104()};
}

}  // namespace ricochet::classic
