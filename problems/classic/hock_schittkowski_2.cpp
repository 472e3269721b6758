#include <array>
#include <cmath>
#include <numbers>

#include "problems/classic/hock_schittkowski.h"
#include "problems/classic/hock_schittkowski_statement.h"

namespace ricochet::classic {
namespace {

using std::numbers::pi;

/// Rosenbrock's valley, the objective of problems 1, 2 and 15.
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

Problem hs_3() {
  return from_formula(hock_schittkowski(3, "Schuldt", Vector{{-20, 0}}, Vector{{20, 20}},
                                        Vector{{10, 1}}, {0, Vector{{0, 0}}, in_closed_form}),
                      []<class Scalar>(const Point<Scalar>& x) {
                        return x[1] + 1e-5 * (x[1] - x[0]) * (x[1] - x[0]);
                      });
}

Problem hs_4() {
  return from_formula(
      hock_schittkowski(4, "Asaadi", Vector{{1, 0}}, Vector{{10, 10}}, Vector{{1.125, 0.125}},
                        {8.0 / 3, Vector{{1, 0}}, in_closed_form}),
      []<class Scalar>(const Point<Scalar>& x) {
        const Scalar a = x[0] + 1.0;
        return a * a * a / 3.0 + x[1];
      });
}

Problem hs_5() {
  return from_formula(
      hock_schittkowski(
          5, "McCormick", Vector{{-1.5, -3}}, Vector{{4, 3}}, Vector{{0, 0}},
          {-std::sqrt(3.0) / 2 - pi / 3, Vector{{-pi / 3 + 0.5, -pi / 3 - 0.5}}, in_closed_form}),
      []<class Scalar>(const Point<Scalar>& x) {
        using std::sin;
        const Scalar off = x[0] - x[1];
        return sin(x[0] + x[1]) + off * off - 1.5 * x[0] + 2.5 * x[1] + 1.0;
      });
}

Problem hs_6() {
  Problem problem = from_formulas(
      hock_schittkowski(6, "Betts", Vector::Constant(2, -10), Vector::Constant(2, 10),
                        Vector{{-1.2, 1}}, {0, Vector{{1, 1}}, in_closed_form, true}),
      []<class Scalar>(const Point<Scalar>& x) { return (1.0 - x[0]) * (1.0 - x[0]); },
      []<class Scalar>(const Point<Scalar>& x) { return Scalar(10.0 * (x[1] - x[0] * x[0])); });
  problem.equalities = 1;
  return problem;
}

Problem hs_7() {
  Problem problem = from_formulas(
      hock_schittkowski(
          7, "Miele, Tietze and Levy", Vector::Constant(2, -10), Vector::Constant(2, 10),
          Vector{{2, 2}},
          {-std::numbers::sqrt3, Vector{{0, std::numbers::sqrt3}}, in_closed_form, true}),
      []<class Scalar>(const Point<Scalar>& x) {
        using std::log;
        return Scalar(log(1.0 + x[0] * x[0]) - x[1]);
      },
      []<class Scalar>(const Point<Scalar>& x) {
        const Scalar a = 1.0 + x[0] * x[0];
        return Scalar(a * a + x[1] * x[1] - 4.0);
      });
  problem.equalities = 1;
  return problem;
}

Problem hs_10() {
  return from_formulas(
      hock_schittkowski(10, "Biggs", Vector{{-20, -20}}, Vector{{20, 20}}, Vector{{-10, 10}},
                        {-1, Vector{{0, 1}}, in_closed_form, true}),
      []<class Scalar>(const Point<Scalar>& x) { return x[0] - x[1]; },
      []<class Scalar>(const Point<Scalar>& x) {
        return 3.0 * x[0] * x[0] - 2.0 * x[0] * x[1] + x[1] * x[1] - 1.0;
      });
}

Problem hs_11() {
  // On y = x^2, where 2 x^3 + x - 5 = 0.
  const double p = 1.0 / 6;
  const double q = 1.25;
  const double d = std::sqrt(q * q + p * p * p);
  const double x = std::cbrt(q + d) + std::cbrt(q - d);
  return from_formulas(
      hock_schittkowski(11, "Biggs", Vector{{-20, -20}}, Vector{{20, 20}}, Vector{{4.9, 0.1}},
                        {(x - 5) * (x - 5) + x * x * x * x - 25, Vector{{x, x * x}},
                         "closed form, by the formula for cubics; published: -8.498464223", true}),
      []<class Scalar>(const Point<Scalar>& at) {
        return (at[0] - 5.0) * (at[0] - 5.0) + at[1] * at[1] - 25.0;
      },
      []<class Scalar>(const Point<Scalar>& at) { return at[0] * at[0] - at[1]; });
}

Problem hs_12() {
  return from_formulas(
      hock_schittkowski(12, "Miele and others", Vector{{-10, -10}}, Vector{{10, 10}},
                        Vector{{0, 0}}, {-30, Vector{{2, 3}}, in_closed_form, true}),
      []<class Scalar>(const Point<Scalar>& x) {
        return 0.5 * x[0] * x[0] + x[1] * x[1] - x[0] * x[1] - 7.0 * x[0] - 7.0 * x[1];
      },
      []<class Scalar>(const Point<Scalar>& x) { return 4.0 * x[0] * x[0] + x[1] * x[1] - 25.0; });
}

Problem hs_15() {
  return from_formulas(
      hock_schittkowski(15, "Betts", Vector{{-10, -10}}, Vector{{0.5, 10}}, Vector{{-2, 1}},
                        {306.5, Vector{{0.5, 2}}, in_closed_form}),
      valley, []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 2>{1.0 - x[0] * x[1], -x[0] - x[1] * x[1]};
      });
}

Problem hs_18() {
  return from_formulas(
      hock_schittkowski(18, "Betts", Vector{{2, 0}}, Vector{{50, 50}}, Vector{{2, 2}},
                        {5, Vector{{std::sqrt(250.0), std::sqrt(2.5)}}, in_closed_form}),
      []<class Scalar>(const Point<Scalar>& x) { return 0.01 * x[0] * x[0] + x[1] * x[1]; },
      []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 2>{25.0 - x[0] * x[1], 25.0 - x[0] * x[0] - x[1] * x[1]};
      });
}

Problem hs_21() {
  return from_formulas(
      hock_schittkowski(21, "Betts", Vector{{2, -50}}, Vector{{50, 50}}, Vector{{-1, -1}},
                        {-99.96, Vector{{2, 0}}, in_closed_form}),
      []<class Scalar>(const Point<Scalar>& x) { return 0.01 * x[0] * x[0] + x[1] * x[1] - 100.0; },
      []<class Scalar>(const Point<Scalar>& x) { return 10.0 - 10.0 * x[0] + x[1]; });
}

Problem hs_22() {
  return from_formulas(
      hock_schittkowski(22, "Bracken and McCormick", Vector{{-10, -10}}, Vector{{10, 10}},
                        Vector{{2, 2}}, {1, Vector{{1, 1}}, in_closed_form, true}),
      []<class Scalar>(const Point<Scalar>& x) {
        return (x[0] - 2.0) * (x[0] - 2.0) + (x[1] - 1.0) * (x[1] - 1.0);
      },
      []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 2>{x[0] + x[1] - 2.0, x[0] * x[0] - x[1]};
      });
}

Problem hs_23() {
  return from_formulas(
      hock_schittkowski(23, "Betts", Vector{{-50, -50}}, Vector{{50, 50}}, Vector{{3, 1}},
                        {2, Vector{{1, 1}}, in_closed_form, true}),
      []<class Scalar>(const Point<Scalar>& x) { return x.squaredNorm(); },
      []<class Scalar>(const Point<Scalar>& x) {
        const Scalar a = x[0] * x[0];
        const Scalar b = x[1] * x[1];
        return std::array<Scalar, 5>{1.0 - x[0] - x[1], 1.0 - a - b, 9.0 - 9.0 * a - b, x[1] - a,
                                     x[0] - b};
      });
}

Problem hs_24() {
  const double root = std::sqrt(3.0);
  return from_formulas(
      hock_schittkowski(24, "Betts, Box", Vector{{0, 0}}, Vector{{10, 10}}, Vector{{1, 0.5}},
                        {-1, Vector{{3, root}}, in_closed_form}),
      [root]<class Scalar>(const Point<Scalar>& x) {
        const Scalar a = x[0] - 3.0;
        return (a * a - 9.0) * x[1] * x[1] * x[1] / (27.0 * root);
      },
      [root]<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 3>{x[1] - x[0] / root, -x[0] - root * x[1],
                                     x[0] + root * x[1] - 6.0};
      });
}

}  // namespace

std::vector<Problem> hock_schittkowski_2() {
  return {hs_1(),  hs_2(),  hs_3(),  hs_4(),  hs_5(),  hs_6(),  hs_7(),  hs_10(),
          hs_11(), hs_12(), hs_15(), hs_18(), hs_21(), hs_22(), hs_23(), hs_24()};
}

}  // namespace ricochet::classic
