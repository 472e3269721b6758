#include <array>
#include <cmath>
#include <numbers>

#include "problems/classic/hock_schittkowski.h"

namespace ricochet::classic {
namespace {

using std::numbers::pi;

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
  return with_equations(
      from_formulas(
          hock_schittkowski(6, "Betts", Vector::Constant(2, -10), Vector::Constant(2, 10),
                            Vector{{-1.2, 1}}, {0, Vector{{1, 1}}, in_closed_form, true}),
          []<class Scalar>(const Point<Scalar>& x) { return square(1.0 - x[0]); },
          []<class Scalar>(const Point<Scalar>& x) { return Scalar(10.0 * (x[1] - x[0] * x[0])); }),
      1);
}

Problem hs_7() {
  return with_equations(
      from_formulas(
          hock_schittkowski(
              7, "Miele, Tietze and Levy", Vector::Constant(2, -10), Vector::Constant(2, 10),
              Vector{{2, 2}},
              {-std::numbers::sqrt3, Vector{{0, std::numbers::sqrt3}}, in_closed_form, true}),
          []<class Scalar>(const Point<Scalar>& x) {
            using std::log;
            return Scalar(log(1.0 + x[0] * x[0]) - x[1]);
          },
          []<class Scalar>(const Point<Scalar>& x) {
            return square(1.0 + x[0] * x[0]) + x[1] * x[1] - 4.0;
          }),
      1);
}

Problem hs_8() {
  const double x = std::sqrt((25 + std::sqrt(301.0)) / 2);
  return with_equations(
      from_formulas(
          hock_schittkowski(8, "", Vector::Constant(2, -10), Vector::Constant(2, 10),
                            Vector{{2, 1}}, {-1, Vector{{x, 9 / x}}, in_closed_form, true}),
          []<class Scalar>(const Point<Scalar>&) { return Scalar(-1.0); },
          []<class Scalar>(const Point<Scalar>& at) {
            return std::array<Scalar, 2>{at.squaredNorm() - 25.0, at[0] * at[1] - 9.0};
          }),
      2);
}

/// The box contains one of the many solutions, (12 k - 3, 16 k - 4).
Problem hs_9() {
  return with_equations(
      from_formulas(
          hock_schittkowski(9, "", Vector::Constant(2, -10), Vector::Constant(2, 10),
                            Vector{{0, 0}}, {-0.5, Vector{{-3, -4}}, in_closed_form, true}),
          []<class Scalar>(const Point<Scalar>& x) {
            using std::cos, std::sin;
            return Scalar(sin(pi / 12 * x[0]) * cos(pi / 16 * x[1]));
          },
          []<class Scalar>(const Point<Scalar>& x) { return 4.0 * x[0] - 3.0 * x[1]; }),
      1);
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

/// At the optimum the gradients of the active constraints are linearly dependent, and the
/// objective's gradient is not in their span: it is no Karush-Kuhn-Tucker point.
Problem hs_13() {
  return from_formulas(
      hock_schittkowski(13, "", Vector{{0, 0}}, Vector{{10, 10}}, Vector{{-2, -2}},
                        {1, Vector{{1, 0}}, in_closed_form}),
      []<class Scalar>(const Point<Scalar>& x) { return square(x[0] - 2.0) + x[1] * x[1]; },
      []<class Scalar>(const Point<Scalar>& x) { return x[1] - cubed(1.0 - x[0]); });
}

Problem hs_14() {
  const double root = std::sqrt(7.0);
  return with_equations(
      from_formulas(
          hock_schittkowski(
              14, "", Vector::Constant(2, -10), Vector::Constant(2, 10), Vector{{2, 2}},
              {9 - 2.875 * root, Vector{{(root - 1) / 2, (root + 1) / 4}}, in_closed_form, true}),
          []<class Scalar>(const Point<Scalar>& x) {
            return square(x[0] - 2.0) + square(x[1] - 1.0);
          },
          []<class Scalar>(const Point<Scalar>& x) {
            return std::array<Scalar, 2>{x[0] - 2.0 * x[1] + 1.0,
                                         0.25 * x[0] * x[0] + x[1] * x[1] - 1.0};
          }),
      1);
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

Problem hs_19() {
  return from_formulas(
      hock_schittkowski(19, "", Vector{{13, 0}}, Vector{{100, 100}}, Vector{{20.1, 5.84}},
                        {-6961.813875580139, Vector{{14.095, 0.8429607892154776}},
                         "published: -6961.81381; digits by Newton's method"}),
      []<class Scalar>(const Point<Scalar>& x) { return cubed(x[0] - 10.0) + cubed(x[1] - 20.0); },
      []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 2>{100.0 - square(x[0] - 5.0) - square(x[1] - 5.0),
                                     square(x[1] - 5.0) + square(x[0] - 6.0) - 82.81};
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

Problem hs_59() {
  return from_formulas(
      hock_schittkowski(59, "", Vector{{0, 0}}, Vector{{75, 65}}, Vector{{90, 10}},
                        {-7.804235953664876, Vector{{13.550088840434151, 51.66017789574667}},
                         "published: -7.804226324, near the minimum; digits by Newton's method"}),
      []<class Scalar>(const Point<Scalar>& at) {
        using std::exp;
        const Scalar& x = at[0];
        const Scalar& y = at[1];
        const Scalar xx = x * x;
        const Scalar yy = y * y;
        const Scalar up_to_square_of_y =
            -75.196 + x * (3.8112 + x * (-0.12694 + x * (0.0020567 - 1.0345e-5 * x))) +
            y * (6.8306 + x * (-0.030234 + x * (0.00128134 + x * (-3.5256e-5 + 2.266e-7 * x)))) +
            yy * (-0.25645 + x * (-3.4054e-4 + x * (5.2375e-6 + 6.3e-8 * x)));
        return Scalar(up_to_square_of_y + yy * y * (0.0034604 + 1.6638e-6 * x - 7e-10 * xx * x) -
                      1.3514e-5 * yy * yy + 28.106 / (y + 1.0) + 2.8673 * exp(5e-4 * x * y));
      },
      []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 3>{700.0 - x[0] * x[1], x[0] * x[0] / 125.0 - x[1],
                                     5.0 * (x[0] - 55.0) - square(x[1] - 50.0)};
      });
}

}  // namespace

std::vector<Problem> hock_schittkowski_2() {
  return {hs_3(),  hs_4(),  hs_5(),  hs_6(),  hs_7(),  hs_8(),  hs_9(),  hs_10(), hs_11(), hs_12(),
          hs_13(), hs_14(), hs_18(), hs_19(), hs_21(), hs_22(), hs_23(), hs_24(), hs_59()};
}

}  // namespace ricochet::classic
