#include <array>

#include "problems/classic/hock_schittkowski.h"
#include "problems/classic/hock_schittkowski_statement.h"

namespace ricochet::classic {
namespace {

Problem hs_38() {
  return from_formula(
      hock_schittkowski(38, "Colville", Vector::Constant(4, -10), Vector::Constant(4, 10),
                        Vector{{-3, -1, -3, -1}}, {0, Vector::Ones(4), in_closed_form, true}),
      []<class Scalar>(const Point<Scalar>& x) {
        const Scalar a = x[1] - x[0] * x[0];
        const Scalar b = 1.0 - x[0];
        const Scalar c = x[3] - x[2] * x[2];
        const Scalar d = 1.0 - x[2];
        const Scalar p = x[1] - 1.0;
        const Scalar q = x[3] - 1.0;
        return 100.0 * a * a + b * b + 90.0 * c * c + d * d + 10.1 * (p * p + q * q) + 19.8 * p * q;
      });
}

Problem hs_43() {
  return from_formulas(
      hock_schittkowski(43, "Rosen and Suzuki", Vector::Constant(4, -10), Vector::Constant(4, 10),
                        Vector::Zero(4), {-44, Vector{{0, 1, 2, -1}}, in_closed_form, true}),
      []<class Scalar>(const Point<Scalar>& x) {
        return x.squaredNorm() + x[2] * x[2] - 5.0 * (x[0] + x[1]) - 21.0 * x[2] + 7.0 * x[3];
      },
      []<class Scalar>(const Point<Scalar>& x) {
        const Scalar a = x[0] * x[0];
        const Scalar b = x[1] * x[1];
        const Scalar c = x[2] * x[2];
        const Scalar d = x[3] * x[3];
        return std::array<Scalar, 3>{a + b + c + d + x[0] - x[1] + x[2] - x[3] - 8.0,
                                     a + 2.0 * b + c + 2.0 * d - x[0] - x[3] - 10.0,
                                     2.0 * a + b + c + 2.0 * x[0] - x[1] - x[3] - 5.0};
      });
}

Problem hs_44() {
  return from_formulas(
      hock_schittkowski(44, "Konno", Vector::Zero(4), Vector::Constant(4, 10), Vector::Zero(4),
                        {-15, Vector{{0, 3, 0, 4}}, in_closed_form}),
      []<class Scalar>(const Point<Scalar>& x) {
        return x[0] - x[1] - x[2] - x[0] * x[2] + x[0] * x[3] + x[1] * x[2] - x[1] * x[3];
      },
      []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 6>{x[0] + 2.0 * x[1] - 8.0,        4.0 * x[0] + x[1] - 12.0,
                                     3.0 * x[0] + 4.0 * x[1] - 12.0, 2.0 * x[2] + x[3] - 8.0,
                                     x[2] + 2.0 * x[3] - 8.0,        x[2] + x[3] - 5.0};
      });
}

Problem hs_76() {
  return from_formulas(
      hock_schittkowski(76, "Murtagh and Sargent", Vector::Zero(4), Vector::Constant(4, 10),
                        Vector::Constant(4, 0.5),
                        {-103.0 / 22, Vector{{3.0 / 11, 23.0 / 11, 0, 6.0 / 11}},
                         "closed form: linear conditions; published: -4.681818181"}),
      []<class Scalar>(const Point<Scalar>& x) {
        return x[0] * x[0] + 0.5 * x[1] * x[1] + x[2] * x[2] + 0.5 * x[3] * x[3] - x[0] * x[2] +
               x[2] * x[3] - x[0] - 3.0 * x[1] + x[2] - x[3];
      },
      []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 3>{x[0] + 2.0 * x[1] + x[2] + x[3] - 5.0,
                                     3.0 * x[0] + x[1] + 2.0 * x[2] - x[3] - 4.0,
                                     1.5 - x[1] - 4.0 * x[2]};
      });
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
        const auto square = [](const Scalar& t) { return Scalar(t * t); };
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
        const auto square = [](const Scalar& t) { return Scalar(t * t); };
        return square(x[0]) + square(x[1]) + x[0] * x[1] - 14.0 * x[0] - 16.0 * x[1] +
               square(x[2] - 10.0) + 4.0 * square(x[3] - 5.0) + square(x[4] - 3.0) +
               2.0 * square(x[5] - 1.0) + 5.0 * square(x[6]) + 7.0 * square(x[7] - 11.0) +
               2.0 * square(x[8] - 10.0) + square(x[9] - 7.0) + 45.0;
      },
      []<class Scalar>(const Point<Scalar>& x) {
        const auto square = [](const Scalar& t) { return Scalar(t * t); };
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

}  // namespace

std::vector<Problem> hock_schittkowski_4() {
  return {hs_38(), hs_43(), hs_44(), hs_76(), hs_100(), hs_113()};
}

}  // namespace ricochet::classic
