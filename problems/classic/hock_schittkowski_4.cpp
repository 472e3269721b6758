#include <ceres/jet.h>

#include <array>
#include <cmath>
#include <numbers>

#include "problems/classic/hock_schittkowski.h"

namespace ricochet::classic {
namespace {

using std::numbers::pi;
using std::numbers::sqrt2;

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

Problem hs_39() {
  return with_equations(from_formulas(
                            hock_schittkowski(39, "", Vector::Constant(4, -10),
                                              Vector::Constant(4, 10), Vector::Constant(4, 2),
                                              {-1, Vector{{1, 1, 0, 0}}, in_closed_form, true}),
                            []<class Scalar>(const Point<Scalar>& x) { return Scalar(-x[0]); },
                            []<class Scalar>(const Point<Scalar>& x) {
                              return std::array<Scalar, 2>{x[1] - cubed(x[0]) - x[2] * x[2],
                                                           x[0] * x[0] - x[1] - x[3] * x[3]};
                            }),
                        2);
}

/// With p = x_1^3 the objective is p^2 - p where the equations hold.
Problem hs_40() {
  const Vector best{
      {std::exp2(-1.0 / 3), std::exp2(-0.5), std::exp2(-11.0 / 12), std::exp2(-0.25)}};
  return with_equations(
      from_formulas(
          hock_schittkowski(40, "", Vector::Constant(4, -10), Vector::Constant(4, 10),
                            Vector::Constant(4, 0.8), {-0.25, best, in_closed_form, true}),
          []<class Scalar>(const Point<Scalar>& x) { return Scalar(-x[0] * x[1] * x[2] * x[3]); },
          []<class Scalar>(const Point<Scalar>& x) {
            return std::array<Scalar, 3>{cubed(x[0]) + x[1] * x[1] - 1.0, x[0] * x[0] * x[3] - x[2],
                                         x[3] * x[3] - x[1]};
          }),
      3);
}

Problem hs_41() {
  return with_equations(
      from_formulas(
          hock_schittkowski(41, "", Vector::Zero(4), Vector{{1, 1, 1, 2}}, Vector::Constant(4, 2),
                            {52.0 / 27, Vector{{2.0 / 3, 1.0 / 3, 1.0 / 3, 2}}, in_closed_form}),
          []<class Scalar>(const Point<Scalar>& x) { return Scalar(2.0 - x[0] * x[1] * x[2]); },
          []<class Scalar>(const Point<Scalar>& x) {
            return x[0] + 2.0 * x[1] + 2.0 * x[2] - x[3];
          }),
      1);
}

Problem hs_42() {
  return with_equations(
      from_formulas(
          hock_schittkowski(
              42, "", Vector::Constant(4, -10), Vector::Constant(4, 10), Vector::Ones(4),
              {28 - 10 * sqrt2, Vector{{2, 2, 0.6 * sqrt2, 0.8 * sqrt2}}, in_closed_form, true}),
          []<class Scalar>(const Point<Scalar>& x) {
            return square(x[0] - 1.0) + square(x[1] - 2.0) + square(x[2] - 3.0) +
                   square(x[3] - 4.0);
          },
          []<class Scalar>(const Point<Scalar>& x) {
            return std::array<Scalar, 2>{x[0] - 2.0, x[2] * x[2] + x[3] * x[3] - 2.0};
          }),
      2);
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

/// The distribution function of a normal variable.
double normal_distribution(double t) {
  return std::erfc(-t / sqrt2) / 2;
}

template <int size>
ceres::Jet<double, size> normal_distribution(const ceres::Jet<double, size>& t) {
  const double density = std::exp(-t.a * t.a / 2) / std::sqrt(2 * pi);
  return {normal_distribution(t.a), density * t.v};
}

HyperDual normal_distribution(const HyperDual& t) {
  const double density = std::exp(-t.value * t.value / 2) / std::sqrt(2 * pi);
  return t.chained(normal_distribution(t.value), density, -t.value * density);
}

/// Problems 68 and 69: the cost of a control chart; `scale` is the cost of a defect, root_size the
/// square root of the sample size.
Problem control_chart(int number, double fixed, double scale, double root_size, Optimum optimum) {
  return with_equations(
      from_formulas(
          hock_schittkowski(number, "", Vector{{1e-4, 0, 0, 0}}, Vector{{100, 100, 2, 2}},
                            Vector::Ones(4), std::move(optimum)),
          [=]<class Scalar>(const Point<Scalar>& x) {
            using std::exp;
            const Scalar grown = exp(x[0]) - 1.0;
            return Scalar(
                (fixed * root_size * root_size - (scale * grown - x[2]) * x[3] / (grown + x[3])) /
                x[0]);
          },
          [=]<class Scalar>(const Point<Scalar>& x) {
            return std::array<Scalar, 2>{x[2] - 2.0 * normal_distribution(Scalar(-x[1])),
                                         x[3] - normal_distribution(Scalar(root_size - x[1])) -
                                             normal_distribution(Scalar(-root_size - x[1]))};
          }),
      2);
}

Problem hs_68() {
  return control_chart(
      68, 1e-4, 1, std::sqrt(24.0),
      {-0.920425003639751,
       Vector{{0.0678585770855116, 3.6462108556881843, 0.00026613562521541034, 0.8948550393735518}},
       "published: -0.920425026; digits by Newton's method"});
}

Problem hs_69() {
  return control_chart(
      69, 0.1, 1000, 2,
      {-956.7128866500263,
       Vector{{0.029371417421708342, 1.1902534504068423, 0.23394679066744595, 0.7916678112438239}},
       "published: -956.71288; digits by Newton's method"});
}

Problem hs_71() {
  return with_equations(
      from_formulas(
          hock_schittkowski(71, "", Vector::Ones(4), Vector::Constant(4, 5), Vector{{1, 5, 5, 1}},
                            {17.014017289156303,
                             Vector{{1, 4.742999637264417, 3.821149984184874, 1.3794082931726723}},
                             "published: 17.0140173; digits by Newton's method"}),
          []<class Scalar>(const Point<Scalar>& x) {
            return x[0] * x[3] * (x[0] + x[1] + x[2]) + x[2];
          },
          []<class Scalar>(const Point<Scalar>& x) {
            return std::array<Scalar, 2>{x.squaredNorm() - 40.0, 25.0 - x[0] * x[1] * x[2] * x[3]};
          }),
      1);
}

/// Sample sizes.
Problem hs_72() {
  return from_formulas(
      hock_schittkowski(
          72, "", Vector::Constant(4, 1e-3), Vector{{4e5, 3e5, 2e5, 1e5}}, Vector::Ones(4),
          {727.679357789613,
           Vector{{193.40742727194632, 179.54707603227456, 185.01806335815152, 168.7067911272406}},
           "published: 727.67937; digits by Newton's method"}),
      []<class Scalar>(const Point<Scalar>& x) { return 1.0 + x[0] + x[1] + x[2] + x[3]; },
      []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 2>{
            4.0 / x[0] + 2.25 / x[1] + 1.0 / x[2] + 0.25 / x[3] - 0.0401,
            0.16 / x[0] + 0.36 / x[1] + 0.64 / x[2] + 0.64 / x[3] - 0.010085};
      });
}

/// Cattle feed.
Problem hs_73() {
  return with_equations(
      from_formulas(
          hock_schittkowski(
              73, "", Vector::Zero(4), Vector::Constant(4, 10), Vector::Ones(4),
              {29.894378159143354,
               Vector{{0.6355215686350697, 0, 0.31270188075152355, 0.05177655061340672}},
               "published: 29.894378; digits by Newton's method"}),
          []<class Scalar>(const Point<Scalar>& x) {
            return 24.55 * x[0] + 26.75 * x[1] + 39.0 * x[2] + 40.5 * x[3];
          },
          []<class Scalar>(const Point<Scalar>& x) {
            using std::sqrt;
            const Scalar spread = sqrt(0.28 * x[0] * x[0] + 0.19 * x[1] * x[1] +
                                       20.5 * x[2] * x[2] + 0.62 * x[3] * x[3]);
            return std::array<Scalar, 3>{
                x[0] + x[1] + x[2] + x[3] - 1.0,
                5.0 - 2.3 * x[0] - 5.6 * x[1] - 11.1 * x[2] - 1.3 * x[3],
                21.0 + 1.645 * spread - 12.0 * x[0] - 11.9 * x[1] - 41.8 * x[2] - 52.1 * x[3]};
          }),
      1);
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

}  // namespace

std::vector<Problem> hock_schittkowski_4() {
  return {hs_38(), hs_39(), hs_40(), hs_41(), hs_42(), hs_43(), hs_44(),
          hs_68(), hs_69(), hs_71(), hs_72(), hs_73(), hs_76()};
}

}  // namespace ricochet::classic
