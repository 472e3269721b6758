#include <array>
#include <cmath>
#include <numbers>

#include "problems/classic/hock_schittkowski.h"

namespace ricochet::classic {
namespace {

using std::numbers::pi;

/// The density of a normal distribution, negated. The printed formula contains an error; this one,
/// from the authors' programs, has the published optimum.
Problem hs_54() {
  return with_equations(
      from_formulas(
          hock_schittkowski(54, "", Vector{{0, -10, 0, 0, -1, 0}},
                            Vector{{2e4, 10, 1e7, 20, 1, 2e8}},
                            Vector{{6e3, 1.5, 4e6, 2, 3e-3, 5e7}},
                            {-std::exp(-27.0 / 280),
                             Vector{{91600.0 / 7, 79.0 / 70, 2e6, 10, 1e-3, 1e8}}, in_closed_form}),
          []<class Scalar>(const Point<Scalar>& x) {
            using std::exp;
            const Scalar first = (x[0] - 1e4) / 8e3;
            const Scalar second = x[1] - 1.0;
            const Scalar sum = (first * first + 0.4 * first * second + second * second) / 0.96 +
                               square((x[2] - 2e6) / 7e6) + square((x[3] - 10.0) / 50.0) +
                               square((x[4] - 1e-3) / 0.05) + square((x[5] - 1e8) / 5e8);
            return Scalar(-exp(-0.5 * sum));
          },
          []<class Scalar>(const Point<Scalar>& x) { return x[0] + 4e3 * x[1] - 1.76e4; }),
      1);
}

Problem hs_55() {
  return with_equations(
      from_formulas(
          hock_schittkowski(
              55, "", Vector::Zero(6), Vector{{1, 10, 10, 1, 10, 10}}, Vector{{1, 2, 0, 0, 0, 2}},
              {19.0 / 3, Vector{{0, 4.0 / 3, 5.0 / 3, 1, 2.0 / 3, 1.0 / 3}}, in_closed_form}),
          []<class Scalar>(const Point<Scalar>& x) {
            using std::exp;
            return Scalar(x[0] + 2.0 * x[1] + 4.0 * x[4] + exp(x[0] * x[3]));
          },
          []<class Scalar>(const Point<Scalar>& x) {
            return std::array<Scalar, 6>{x[0] + 2.0 * x[1] + 5.0 * x[4] - 6.0,
                                         x[0] + x[1] + x[2] - 3.0,
                                         x[3] + x[4] + x[5] - 2.0,
                                         x[0] + x[3] - 1.0,
                                         x[1] + x[4] - 2.0,
                                         x[2] + x[5] - 2.0};
          }),
      6);
}

Problem hs_56() {
  const double angle = std::asin(std::sqrt(1 / 4.2));
  const double small = std::asin(std::sqrt(2.0 / 7));
  return with_equations(
      from_formulas(
          hock_schittkowski(
              56, "", Vector::Constant(7, -10), Vector::Constant(7, 10),
              Vector{{1, 1, 1, angle, angle, angle, std::asin(std::sqrt(5 / 7.2))}},
              {-3.456, Vector{{2.4, 1.2, 1.2, std::asin(std::sqrt(4.0 / 7)), small, small, pi / 2}},
               in_closed_form, true}),
          []<class Scalar>(const Point<Scalar>& x) { return Scalar(-x[0] * x[1] * x[2]); },
          []<class Scalar>(const Point<Scalar>& x) {
            using std::sin;
            return std::array<Scalar, 4>{x[0] - 4.2 * square(sin(x[3])),
                                         x[1] - 4.2 * square(sin(x[4])),
                                         x[2] - 4.2 * square(sin(x[5])),
                                         x[0] + 2.0 * x[1] + 2.0 * x[2] - 7.2 * square(sin(x[6]))};
          }),
      4);
}

/// Design of a transformer.
Problem hs_93() {
  return from_formulas(
      hock_schittkowski(93, "", Vector::Zero(6), Vector::Constant(6, 20),
                        Vector{{5.54, 4.4, 12.02, 11.82, 0.702, 0.852}},
                        {135.07596282915182,
                         Vector{{5.332666335528811, 4.65674405917202, 10.432991940468266,
                                 12.08230634006371, 0.7526074362238322, 0.8786508746591397}},
                         "published: 135.075961; digits by Newton's method"}),
      []<class Scalar>(const Point<Scalar>& x) {
        const Scalar first = x[0] * x[3] * (x[0] + x[1] + x[2]);
        const Scalar second = x[1] * x[2] * (x[0] + 1.57 * x[1] + x[3]);
        return 0.0204 * first + 0.0187 * second + 0.0607 * first * x[4] * x[4] +
               0.0437 * second * x[5] * x[5];
      },
      []<class Scalar>(const Point<Scalar>& x) {
        const Scalar first = x[0] * x[3] * (x[0] + x[1] + x[2]);
        const Scalar second = x[1] * x[2] * (x[0] + 1.57 * x[1] + x[3]);
        return std::array<Scalar, 2>{
            2.07 - 0.001 * x.prod(),
            0.00062 * first * x[4] * x[4] + 0.00058 * second * x[5] * x[5] - 1.0};
      });
}

/// Problems 95 to 98, which differ in the lower limits of their constraints.
Problem with_limits(int number, const std::array<double, 4>& least, Optimum optimum) {
  return from_formulas(
      hock_schittkowski(number, "", Vector::Zero(6),
                        Vector{{0.31, 0.046, 0.068, 0.042, 0.028, 0.0134}}, Vector::Zero(6),
                        std::move(optimum)),
      []<class Scalar>(const Point<Scalar>& x) {
        return 4.3 * x[0] + 31.8 * x[1] + 63.3 * x[2] + 15.8 * x[3] + 68.5 * x[4] + 4.7 * x[5];
      },
      [least]<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 4>{
            least[0] - (17.1 * x[0] + 38.2 * x[1] + 204.2 * x[2] + 212.3 * x[3] + 623.4 * x[4] +
                        1495.5 * x[5] - 169.0 * x[0] * x[2] - 3580.0 * x[2] * x[4] -
                        3810.0 * x[3] * x[4] - 18500.0 * x[3] * x[5] - 24300.0 * x[4] * x[5]),
            least[1] - (17.9 * x[0] + 36.8 * x[1] + 113.9 * x[2] + 169.7 * x[3] + 337.8 * x[4] +
                        1385.2 * x[5] - 139.0 * x[0] * x[2] - 2450.0 * x[3] * x[4] -
                        16600.0 * x[3] * x[5] - 17200.0 * x[4] * x[5]),
            least[2] - (-273.0 * x[1] - 70.0 * x[3] - 819.0 * x[4] + 26000.0 * x[3] * x[4]),
            least[3] - (159.9 * x[0] - 311.0 * x[1] + 587.0 * x[3] + 391.0 * x[4] + 2198.0 * x[5] -
                        14000.0 * x[0] * x[5])};
      });
}

/// The optimum of problems 95 and 96, where the first constraint is active.
Optimum optimum_of_95() {
  const double last = 4.97 / 1495.5;
  return {4.7 * last, Vector{{0, 0, 0, 0, 0, last}},
          "closed form: one constraint, linear there; published: 0.015619514"};
}

/// The optimum of problems 97 and 98, where the first constraint and the bounds of x_5 and x_6 are
/// active.
Optimum optimum_of_97() {
  return {3.135809122807016, Vector{{0.2685649122807014, 0, 0, 0, 0.028, 0.0134}},
          "closed form: one constraint, linear there; published: 3.1358091"};
}

Problem hs_95() {
  return with_limits(95, {4.97, -1.88, -29.08, -78.02}, optimum_of_95());
}

Problem hs_96() {
  return with_limits(96, {4.97, -1.88, -69.08, -118.02}, optimum_of_95());
}

Problem hs_97() {
  return with_limits(97, {32.97, 25.12, -29.08, -78.02}, optimum_of_97());
}

Problem hs_98() {
  return with_limits(98, {32.97, 25.12, -124.08, -173.02}, optimum_of_97());
}

/// A rocket of maximal range: it turns at given times, and each phase has a given thrust.
Problem hs_99() {
  constexpr std::array<double, 8> time = {0, 25, 50, 100, 150, 200, 290, 380};
  constexpr std::array<double, 8> thrust = {0, 50, 50, 75, 75, 75, 100, 100};
  return with_equations(
      from_formulas(
          hock_schittkowski(99, "", Vector::Zero(7), Vector::Constant(7, 1.58),
                            Vector::Constant(7, 0.5),
                            {-831079891.5101074,
                             Vector{{0.5424678162123169, 0.5290214242019767, 0.5084491553164001,
                                     0.4802688509618159, 0.45123634979664673, 0.4091830824209852,
                                     0.3527878917811228}},
                             "published: -831079892; digits by Newton's method"}),
          [=]<class Scalar>(const Point<Scalar>& x) {
            using std::cos;
            Scalar along(0.0);
            for (std::size_t i = 1; i < time.size(); ++i) {
              along +=
                  thrust[i] * (time[i] - time[i - 1]) * cos(x[static_cast<Eigen::Index>(i - 1)]);
            }
            return Scalar(-along * along);
          },
          [=]<class Scalar>(const Point<Scalar>& x) {
            using std::sin;
            Scalar height(0.0), climb(0.0);
            for (std::size_t i = 1; i < time.size(); ++i) {
              const double step = time[i] - time[i - 1];
              const Scalar lift = thrust[i] * sin(x[static_cast<Eigen::Index>(i - 1)]) - 32.0;
              height += 0.5 * step * step * lift + step * climb;
              climb += step * lift;
            }
            return std::array<Scalar, 2>{height - 1e5, climb - 1e3};
          }),
      2);
}

Problem hs_100() {
  return from_formulas(
      hock_schittkowski(
          100, "Asaadi, Charalambous, Wong", Vector::Constant(7, -10), Vector::Constant(7, 10),
          Vector{{1, 2, 0, 4, 0, 1, 1}},
          {680.63005737440199,
           Vector{{2.33049937287957, 1.951372372896889, -0.47754139238887161, 4.3657262336558098,
                   -0.62448697052681745, 1.0381310186079584, 1.5942267116118685}},
           "published: 680.6300573; digits by Newton's method", true}),
      []<class Scalar>(const Point<Scalar>& x) {
        return square(x[0] - 10.0) + 5.0 * square(x[1] - 12.0) + square(x[2] * x[2]) +
               3.0 * square(x[3] - 11.0) + 10.0 * square(x[4] * x[4] * x[4]) + 7.0 * square(x[5]) +
               square(x[6] * x[6]) - 4.0 * x[5] * x[6] - 10.0 * x[5] - 8.0 * x[6];
      },
      []<class Scalar>(const Point<Scalar>& x) {
        const Scalar a = x[0] * x[0];
        const Scalar b = x[1] * x[1];
        const Scalar c = x[2] * x[2];
        return std::array<Scalar, 4>{
            2.0 * a + 3.0 * b * b + x[2] + 4.0 * x[3] * x[3] + 5.0 * x[4] - 127.0,
            7.0 * x[0] + 3.0 * x[1] + 10.0 * c + x[3] - x[4] - 282.0,
            23.0 * x[0] + b + 6.0 * x[5] * x[5] - 8.0 * x[6] - 196.0,
            4.0 * a + b - 3.0 * x[0] * x[1] + 2.0 * c + 5.0 * x[5] - 11.0 * x[6]};
      });
}

}  // namespace

std::vector<Problem> hock_schittkowski_6() {
  return {hs_54(), hs_55(), hs_56(), hs_93(), hs_95(),
          hs_96(), hs_97(), hs_98(), hs_99(), hs_100()};
}

}  // namespace ricochet::classic
