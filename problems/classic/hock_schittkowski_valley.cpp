#include <array>
#include <cmath>
#include <numbers>

#include "problems/classic/hock_schittkowski.h"
#include "problems/classic/hock_schittkowski_statement.h"

namespace ricochet::classic {
namespace {

using std::numbers::sqrt3;

/// Rosenbrock's valley, the objective of all problems of this file.
constexpr auto valley = []<class Scalar>(const Point<Scalar>& x) {
  const Scalar across = x[1] - x[0] * x[0];
  const Scalar along = 1.0 - x[0];
  return Scalar(100.0 * across * across + along * along);
};

Problem hs_1() {
  return from_formula(hock_schittkowski(1, "Betts", Vector{{-10, -1.5}}, Vector{{10, 10}},
                                        Vector{{-2, 1}}, {0, Vector{{1, 1}}, in_closed_form, true}),
                      valley);
}

Problem hs_2() {
  const double a = std::sqrt(598.0 / 1200);
  const double b = 400 * a * a * a;
  const double x = 2 * a * std::cos(std::acos(1 / b) / 3);
  const double across = 1.5 - x * x;
  return from_formula(
      hock_schittkowski(
          2, "Betts", Vector{{-10, 1.5}}, Vector{{10, 10}}, Vector{{-2, 1}},
          {100 * across * across + (1 - x) * (1 - x), Vector{{x, 1.5}}, in_closed_form}),
      valley);
}

Problem hs_15() {
  return from_formulas(
      hock_schittkowski(15, "Betts", Vector{{-10, -10}}, Vector{{0.5, 10}}, Vector{{-2, 1}},
                        {306.5, Vector{{0.5, 2}}, in_closed_form}),
      valley, []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 2>{1.0 - x[0] * x[1], -x[0] - x[1] * x[1]};
      });
}

Problem hs_16() {
  return from_formulas(
      hock_schittkowski(16, "", Vector{{-0.5, -10}}, Vector{{0.5, 1}}, Vector{{-2, 1}},
                        {0.25, Vector{{0.5, 0.25}}, in_closed_form}),
      valley, []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 2>{-x[0] - x[1] * x[1], -x[0] * x[0] - x[1]};
      });
}

Problem hs_17() {
  return from_formulas(hock_schittkowski(17, "", Vector{{-0.5, -10}}, Vector{{0.5, 1}},
                                         Vector{{-2, 1}}, {1, Vector{{0, 0}}, in_closed_form}),
                       valley, []<class Scalar>(const Point<Scalar>& x) {
                         return std::array<Scalar, 2>{x[0] - x[1] * x[1], x[1] - x[0] * x[0]};
                       });
}

Problem hs_20() {
  const double within = std::nextafter(sqrt3 / 2, 1.0);  // sqrt3 / 2 is rounded down
  return from_formulas(
      hock_schittkowski(20, "", Vector{{-0.5, -10}}, Vector{{0.5, 10}}, Vector{{-2, 1}},
                        {81.5 - 25 * sqrt3, Vector{{0.5, within}}, in_closed_form}),
      valley, []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 3>{-x[0] - x[1] * x[1], -x[0] * x[0] - x[1],
                                     1.0 - x[0] * x[0] - x[1] * x[1]};
      });
}

Problem hs_58() {
  return from_formulas(
      hock_schittkowski(
          58, "", Vector{{-2, -10}}, Vector{{0.5, 10}}, Vector{{-2, 1}},
          {3.1903367442647417, Vector{{-0.7861513777574234, 0.6180339887498949}},
           "closed form, x_1^2 = x_2 and x_1^2 + x_2^2 = 1; published: 3.19033354957, near it"}),
      valley, []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 3>{x[0] - x[1] * x[1], x[1] - x[0] * x[0],
                                     1.0 - x[0] * x[0] - x[1] * x[1]};
      });
}

}  // namespace

std::vector<Problem> hock_schittkowski_valley() {
  return {hs_1(), hs_2(), hs_15(), hs_16(), hs_17(), hs_20(), hs_58()};
}

}  // namespace ricochet::classic
