#include <array>
#include <cmath>
#include <numbers>

#include "problems/classic/hock_schittkowski.h"

namespace ricochet::classic {
namespace {

using std::numbers::sqrt2;
using std::numbers::sqrt3;

/// Minus the volume of a box with these edges, the objective of problems 29, 36 and 37.
constexpr auto minus_volume = []<class Scalar>(const Point<Scalar>& x) {
  return Scalar(-x[0] * x[1] * x[2]);
};

/// exp(x_1) <= x_2 and exp(x_2) <= x_3, the constraints of problems 34 and 66.
constexpr auto above_exponentials = []<class Scalar>(const Point<Scalar>& x) {
  using std::exp;
  return std::array<Scalar, 2>{exp(x[0]) - x[1], exp(x[1]) - x[2]};
};

Problem hs_26() {
  return with_equations(
      from_formulas(
          hock_schittkowski(26, "", Vector::Constant(3, -10), Vector::Constant(3, 10),
                            Vector{{-2.6, 2, 2}}, {0, Vector::Ones(3), in_closed_form, true}),
          []<class Scalar>(const Point<Scalar>& x) {
            return square(x[0] - x[1]) + square(square(x[1] - x[2]));
          },
          []<class Scalar>(const Point<Scalar>& x) {
            return (1.0 + x[1] * x[1]) * x[0] + square(x[2] * x[2]) - 3.0;
          }),
      1);
}

Problem hs_27() {
  return with_equations(
      from_formulas(
          hock_schittkowski(27, "", Vector::Constant(3, -10), Vector::Constant(3, 10),
                            Vector::Constant(3, 2),
                            {0.04, Vector{{-1, 1, 0}}, in_closed_form, true}),
          []<class Scalar>(const Point<Scalar>& x) {
            return 0.01 * square(x[0] - 1.0) + square(x[1] - x[0] * x[0]);
          },
          []<class Scalar>(const Point<Scalar>& x) { return x[0] + x[2] * x[2] + 1.0; }),
      1);
}

Problem hs_28() {
  return with_equations(from_formulas(
                            hock_schittkowski(28, "", Vector::Constant(3, -10),
                                              Vector::Constant(3, 10), Vector{{-4, 1, 1}},
                                              {0, Vector{{0.5, -0.5, 0.5}}, in_closed_form, true}),
                            []<class Scalar>(const Point<Scalar>& x) {
                              return square(x[0] + x[1]) + square(x[1] + x[2]);
                            },
                            []<class Scalar>(const Point<Scalar>& x) {
                              return x[0] + 2.0 * x[1] + 3.0 * x[2] - 1.0;
                            }),
                        1);
}

Problem hs_29() {
  return from_formulas(
      hock_schittkowski(29, "Biggs", Vector::Constant(3, -10), Vector::Constant(3, 10),
                        Vector::Ones(3),
                        {-16 * sqrt2, Vector{{4, 2 * sqrt2, 2}}, in_closed_form, true}),
      minus_volume, []<class Scalar>(const Point<Scalar>& x) {
        return x[0] * x[0] + 2.0 * x[1] * x[1] + 4.0 * x[2] * x[2] - 48.0;
      });
}

Problem hs_30() {
  return from_formulas(
      hock_schittkowski(30, "Betts", Vector{{1, -10, -10}}, Vector::Constant(3, 10),
                        Vector::Ones(3), {1, Vector{{1, 0, 0}}, in_closed_form}),
      []<class Scalar>(const Point<Scalar>& x) { return x.squaredNorm(); },
      []<class Scalar>(const Point<Scalar>& x) { return 1.0 - x[0] * x[0] - x[1] * x[1]; });
}

Problem hs_31() {
  return from_formulas(
      hock_schittkowski(31, "Betts", Vector{{-10, 1, -10}}, Vector{{10, 10, 1}}, Vector::Ones(3),
                        {6, Vector{{1 / sqrt3, sqrt3, 0}}, in_closed_form}),
      []<class Scalar>(const Point<Scalar>& x) {
        return 9.0 * x[0] * x[0] + x[1] * x[1] + 9.0 * x[2] * x[2];
      },
      []<class Scalar>(const Point<Scalar>& x) { return 1.0 - x[0] * x[1]; });
}

Problem hs_32() {
  return with_equations(
      from_formulas(
          hock_schittkowski(32, "", Vector::Zero(3), Vector::Constant(3, 10),
                            Vector{{0.1, 0.7, 0.2}}, {1, Vector{{0, 0, 1}}, in_closed_form}),
          []<class Scalar>(const Point<Scalar>& x) {
            return square(x[0] + 3.0 * x[1] + x[2]) + 4.0 * square(x[0] - x[1]);
          },
          []<class Scalar>(const Point<Scalar>& x) {
            return std::array<Scalar, 2>{1.0 - x[0] - x[1] - x[2],
                                         3.0 + cubed(x[0]) - 6.0 * x[1] - 4.0 * x[2]};
          }),
      1);
}

Problem hs_33() {
  return from_formulas(
      hock_schittkowski(33, "Beltrami", Vector::Zero(3), Vector{{10, 10, 5}}, Vector{{0, 0, 3}},
                        {sqrt2 - 6, Vector{{0, sqrt2, sqrt2}}, in_closed_form}),
      []<class Scalar>(const Point<Scalar>& x) {
        return (x[0] - 1.0) * (x[0] - 2.0) * (x[0] - 3.0) + x[2];
      },
      []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 2>{x[0] * x[0] + x[1] * x[1] - x[2] * x[2],
                                     4.0 - x.squaredNorm()};
      });
}

/// ln y, or the next smaller number if its exponential exceeds y.
double log_within(double y) {
  double x = std::log(y);
  while (std::exp(x) > y) x = std::nextafter(x, 0.0);
  return x;
}

Problem hs_34() {
  const double second = log_within(10);
  const double first = log_within(second);
  return from_formulas(
      hock_schittkowski(34, "Eckhardt", Vector::Zero(3), Vector{{100, 100, 10}},
                        Vector{{0, 1.05, 2.9}},
                        {-first, Vector{{first, second, 10}}, in_closed_form}),
      []<class Scalar>(const Point<Scalar>& x) { return Scalar(-x[0]); }, above_exponentials);
}

Problem hs_35() {
  return from_formulas(
      hock_schittkowski(35, "Beale", Vector::Zero(3), Vector::Constant(3, 10),
                        Vector::Constant(3, 0.5),
                        {1.0 / 9, Vector{{4.0 / 3, 7.0 / 9, 4.0 / 9}}, in_closed_form}),
      []<class Scalar>(const Point<Scalar>& x) {
        return 9.0 - 8.0 * x[0] - 6.0 * x[1] - 4.0 * x[2] + 2.0 * x[0] * x[0] + 2.0 * x[1] * x[1] +
               x[2] * x[2] + 2.0 * x[0] * x[1] + 2.0 * x[0] * x[2];
      },
      []<class Scalar>(const Point<Scalar>& x) { return x[0] + x[1] + 2.0 * x[2] - 3.0; });
}

Problem hs_36() {
  return from_formulas(
      hock_schittkowski(36, "Biggs", Vector::Zero(3), Vector{{20, 11, 42}}, Vector::Constant(3, 10),
                        {-3300, Vector{{20, 11, 15}}, in_closed_form}),
      minus_volume,
      []<class Scalar>(const Point<Scalar>& x) { return x[0] + 2.0 * x[1] + 2.0 * x[2] - 72.0; });
}

Problem hs_37() {
  return from_formulas(
      hock_schittkowski(37, "Betts, Box", Vector::Zero(3), Vector::Constant(3, 42),
                        Vector::Constant(3, 10), {-3456, Vector{{24, 12, 12}}, in_closed_form}),
      minus_volume, []<class Scalar>(const Point<Scalar>& x) {
        const Scalar girth = x[0] + 2.0 * x[1] + 2.0 * x[2];
        return std::array<Scalar, 2>{girth - 72.0, -girth};
      });
}

Problem hs_60() {
  return with_equations(
      from_formulas(
          hock_schittkowski(60, "", Vector::Constant(3, -10), Vector::Constant(3, 10),
                            Vector::Constant(3, 2),
                            {0.03256820025506984,
                             Vector{{1.1048590197333166, 1.1966741822882572, 1.535262260325326}},
                             "published: 0.03256820025; digits by Newton's method"}),
          []<class Scalar>(const Point<Scalar>& x) {
            return square(x[0] - 1.0) + square(x[0] - x[1]) + square(square(x[1] - x[2]));
          },
          []<class Scalar>(const Point<Scalar>& x) {
            return x[0] * (1.0 + x[1] * x[1]) + square(x[2] * x[2]) - (4.0 + 3.0 * sqrt2);
          }),
      1);
}

Problem hs_61() {
  return with_equations(
      from_formulas(
          hock_schittkowski(61, "", Vector::Constant(3, -10), Vector::Constant(3, 10),
                            Vector::Zero(3),
                            {-143.64614219778025,
                             Vector{{5.326770135563928, -2.118998632218976, 3.2104642253505506}},
                             "published: -143.6461422; digits by Newton's method"}),
          []<class Scalar>(const Point<Scalar>& x) {
            return 4.0 * x[0] * x[0] + 2.0 * x[1] * x[1] + 2.0 * x[2] * x[2] - 33.0 * x[0] +
                   16.0 * x[1] - 24.0 * x[2];
          },
          []<class Scalar>(const Point<Scalar>& x) {
            return std::array<Scalar, 2>{3.0 * x[0] - 2.0 * x[1] * x[1] - 7.0,
                                         4.0 * x[0] - x[2] * x[2] - 11.0};
          }),
      2);
}

Problem hs_62() {
  return with_equations(
      from_formulas(
          hock_schittkowski(62, "", Vector::Zero(3), Vector::Ones(3), Vector{{0.7, 0.2, 0.1}},
                            {-26272.514487318258,
                             Vector{{0.6178126908126925, 0.328202223119669, 0.05398508606763848}},
                             "published: -26272.51448; digits by Newton's method"}),
          []<class Scalar>(const Point<Scalar>& x) {
            using std::log;
            const Scalar third = x[2] + 0.03;
            const Scalar second = third + x[1];
            const Scalar first = second + x[0];
            return Scalar(-32.174 * (255.0 * log(first / (second + 0.09 * x[0])) +
                                     280.0 * log(second / (third + 0.07 * x[1])) +
                                     290.0 * log(third / (0.13 * x[2] + 0.03))));
          },
          []<class Scalar>(const Point<Scalar>& x) { return x[0] + x[1] + x[2] - 1.0; }),
      1);
}

Problem hs_63() {
  return with_equations(
      from_formulas(
          hock_schittkowski(63, "", Vector::Zero(3), Vector::Constant(3, 10),
                            Vector::Constant(3, 2),
                            {961.7151721300521,
                             Vector{{3.5121213418747184, 0.21698794151522266, 3.5521711548270187}},
                             "published: 961.7151721; digits by Newton's method"}),
          []<class Scalar>(const Point<Scalar>& x) {
            return 1000.0 - x[0] * x[0] - 2.0 * x[1] * x[1] - x[2] * x[2] - x[0] * x[1] -
                   x[0] * x[2];
          },
          []<class Scalar>(const Point<Scalar>& x) {
            return std::array<Scalar, 2>{8.0 * x[0] + 14.0 * x[1] + 7.0 * x[2] - 56.0,
                                         x.squaredNorm() - 25.0};
          }),
      2);
}

Problem hs_64() {
  return from_formulas(
      hock_schittkowski(
          64, "Best", Vector::Constant(3, 1e-5), Vector::Constant(3, 1000), Vector::Ones(3),
          {6299.8424279215205, Vector{{108.73470491089891, 85.126212790893788, 204.32459661260555}},
           "published: 6299.842428; digits by Newton's method"}),
      []<class Scalar>(const Point<Scalar>& x) {
        return 5.0 * x[0] + 50000.0 / x[0] + 20.0 * x[1] + 72000.0 / x[1] + 10.0 * x[2] +
               144000.0 / x[2];
      },
      []<class Scalar>(const Point<Scalar>& x) {
        return 4.0 / x[0] + 32.0 / x[1] + 120.0 / x[2] - 1.0;
      });
}

Problem hs_65() {
  return from_formulas(
      hock_schittkowski(65, "Murtagh and Sargent", Vector{{-4.5, -4.5, -5}}, Vector{{4.5, 4.5, 5}},
                        Vector{{-5, 5, 0}},
                        {0.95352885680478261,
                         Vector{{3.6504617252130367, 3.6504617252130367, 4.6204175553200084}},
                         "published: 0.9535288567; digits by Newton's method"}),
      []<class Scalar>(const Point<Scalar>& x) {
        const Scalar a = x[0] - x[1];
        const Scalar b = x[0] + x[1] - 10.0;
        const Scalar c = x[2] - 5.0;
        return a * a + b * b / 9.0 + c * c;
      },
      []<class Scalar>(const Point<Scalar>& x) { return x.squaredNorm() - 48.0; });
}

Problem hs_66() {
  return from_formulas(
      hock_schittkowski(66, "Eckhardt", Vector::Zero(3), Vector{{100, 100, 10}},
                        Vector{{0, 1.05, 2.9}},
                        {0.51816327418154107,
                         Vector{{0.18412648792284772, 1.2021678731970429, 3.327322322599096}},
                         "published: 0.5181632741; digits by Newton's method"}),
      []<class Scalar>(const Point<Scalar>& x) { return 0.2 * x[2] - 0.8 * x[0]; },
      above_exponentials);
}

}  // namespace

std::vector<Problem> hock_schittkowski_3() {
  return {hs_26(), hs_27(), hs_28(), hs_29(), hs_30(), hs_31(), hs_32(), hs_33(), hs_34(), hs_35(),
          hs_36(), hs_37(), hs_60(), hs_61(), hs_62(), hs_63(), hs_64(), hs_65(), hs_66()};
}

}  // namespace ricochet::classic
