#include <array>
#include <cmath>
#include <numbers>

#include "problems/held_out/held_out.h"

namespace ricochet::held_out {

namespace {

using namespace classic;
using std::numbers::pi;
using std::numbers::sqrt2;

constexpr const char* cec = "Liang et al. (2006), problem definitions of the CEC 2006 competition";
constexpr const char* design =
    "Mirjalili, Mirjalili and Lewis (2014), doi 10.1016/j.advengsoft.2013.12.007";

Statement design_of(const char* name, const char* source, Vector lower, Vector upper, double best,
                    Vector best_point, const char* provenance) {
  return stated("outside-constrained", name, source, std::move(lower), std::move(upper), {}, best,
                std::move(best_point), provenance);
}

template <class Scalar>
Scalar square(const Scalar& t) {
  return t * t;
}

Problem g01() {
  Vector upper = Vector::Ones(13), best = Vector::Ones(13);
  upper.segment(9, 3).setConstant(100);
  best.segment(9, 3).setConstant(3);
  return from_formulas(
      design_of("g01", cec, Vector::Zero(13), upper, -15, best, "published: -15, exact"),
      []<class Scalar>(const Point<Scalar>& x) {
        return Scalar(5.0 * x.head(4).sum() - 5.0 * x.head(4).squaredNorm() - x.tail(9).sum());
      },
      []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 9>{2.0 * x[0] + 2.0 * x[1] + x[9] + x[10] - 10.0,
                                     2.0 * x[0] + 2.0 * x[2] + x[9] + x[11] - 10.0,
                                     2.0 * x[1] + 2.0 * x[2] + x[10] + x[11] - 10.0,
                                     -8.0 * x[0] + x[9],
                                     -8.0 * x[1] + x[10],
                                     -8.0 * x[2] + x[11],
                                     -2.0 * x[3] - x[4] + x[9],
                                     -2.0 * x[5] - x[6] + x[10],
                                     -2.0 * x[7] - x[8] + x[11]};
      });
}

Problem g03() {
  Statement statement = design_of("g03", cec, Vector::Zero(10), Vector::Ones(10), -1,
                                  Vector::Constant(10, 1 / std::sqrt(10.0)),
                                  "closed form: of equal numbers the product is largest");
  statement.start = Vector::Constant(10, 0.5);
  statement.start[0] = 0.2;
  Problem problem = from_formulas(
      statement,
      []<class Scalar>(const Point<Scalar>& x) {
        Scalar product(-1);
        for (const Scalar& t : x) product *= std::sqrt(10.0) * t;
        return product;
      },
      []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 1>{Scalar(x.squaredNorm() - 1.0)};
      });
  problem.equalities = 1;
  return problem;
}

Problem g06() {
  return from_formulas(
      design_of("g06", cec, Vector{{13, 0}}, Vector{{100, 100}}, -6961.813875580138,
                Vector{{14.095, 0.8429607892154796}},
                "published: -6961.81387558015; both constraints are active"),
      []<class Scalar>(const Point<Scalar>& x) {
        const Scalar a = x[0] - 10.0, b = x[1] - 20.0;
        return Scalar(a * a * a + b * b * b);
      },
      []<class Scalar>(const Point<Scalar>& x) {
        const Scalar b = square(Scalar(x[1] - 5.0));
        return std::array<Scalar, 2>{100.0 - square(Scalar(x[0] - 5.0)) - b,
                                     square(Scalar(x[0] - 6.0)) + b - 82.81};
      });
}

Problem g08() {
  return from_formulas(
      design_of("g08", cec, Vector::Constant(2, 0.01), Vector::Constant(2, 10), -0.0958250414180359,
                Vector{{1.2279713527638443, 4.245373366458419}},
                "published: -0.0958250414180359; digits by Newton's method"),
      []<class Scalar>(const Point<Scalar>& x) {
        using std::sin;
        const Scalar wave = sin(2 * pi * x[0]);
        return Scalar(-wave * wave * wave * sin(2 * pi * x[1]) /
                      (x[0] * x[0] * x[0] * (x[0] + x[1])));
      },
      []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 2>{x[0] * x[0] - x[1] + 1.0,
                                     1.0 - x[0] + square(Scalar(x[1] - 4.0))};
      });
}

Problem g11() {
  Statement statement = design_of("g11", cec, Vector::Constant(2, -1), Vector::Ones(2), 0.75,
                                  Vector{{1 / sqrt2, 0.5}}, "closed form, one of two");
  statement.start = Vector{{0.3, -0.8}};
  Problem problem = from_formulas(
      statement,
      []<class Scalar>(const Point<Scalar>& x) {
        return Scalar(x[0] * x[0] + square(Scalar(x[1] - 1.0)));
      },
      []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 1>{x[1] - x[0] * x[0]};
      });
  problem.equalities = 1;
  return problem;
}

Problem g21() {
  Problem problem = from_formulas(
      design_of("g21", cec, Vector{{0, 0, 0, 100, 6.3, 5.9, 4.5}},
                Vector{{1000, 40, 40, 300, 6.7, 6.4, 6.25}}, 193.78692747104867,
                Vector{{193.78692747104867, 0, 17.32848970865875, 100.00202459285394,
                        6.684609196923658, 5.991469608577307, 6.214600000017984}},
                "published: 193.7245, with equalities met to 1e-4 only; digits by Newton's method"),
      []<class Scalar>(const Point<Scalar>& x) { return x[0]; },
      []<class Scalar>(const Point<Scalar>& x) {
        using std::log;
        using std::pow;
        // At 0 the power has no derivative: what is added there changes it by less than 1e-6.
        const auto power = [](const Scalar& t) { return pow(t + 1e-12, 0.6); };
        return std::array<Scalar, 6>{-300.0 * x[2] + 7500.0 * x[4] - 7500.0 * x[5] -
                                         25.0 * x[3] * x[4] + 25.0 * x[3] * x[5] + x[2] * x[3],
                                     100.0 * x[1] + 155.365 * x[3] + 2500.0 * x[6] - x[1] * x[3] -
                                         25.0 * x[3] * x[6] - 15536.5,
                                     -x[4] + log(900.0 - x[3]),
                                     -x[5] + log(x[3] + 300.0),
                                     -x[6] + log(700.0 - 2.0 * x[3]),
                                     -x[0] + 35.0 * power(x[1]) + 35.0 * power(x[2])};
      });
  problem.equalities = 5;
  return problem;
}

Problem g24() {
  return from_formulas(
      design_of("g24", cec, Vector::Zero(2), Vector{{3, 4}}, -5.50801327159536,
                Vector{{2.32952019747762, 3.17849307411774}},
                "published: -5.50801327159536; both constraints are active"),
      []<class Scalar>(const Point<Scalar>& x) { return Scalar(-x[0] - x[1]); },
      []<class Scalar>(const Point<Scalar>& x) {
        const Scalar a = x[0] * x[0];
        return std::array<Scalar, 2>{
            x[1] - a * (2.0 * a - 8.0 * x[0] + 8.0) - 2.0,
            x[1] - a * (4.0 * a - 32.0 * x[0] + 88.0) + 96.0 * x[0] - 36.0};
      });
}

Problem welded_beam() {
  return from_formulas(
      design_of(
          "welded-beam", design, Vector{{0.1, 0.1, 0.1, 0.1}}, Vector{{2, 10, 10, 2}},
          1.724852308597365,
          Vector{{0.20572963978607947, 3.470488665628002, 9.036623910357633, 0.20572963978607947}},
          "published: 1.724852; digits by Newton's method"),
      []<class Scalar>(const Point<Scalar>& x) {
        return Scalar(1.10471 * x[0] * x[0] * x[1] + 0.04811 * x[2] * x[3] * (14.0 + x[1]));
      },
      []<class Scalar>(const Point<Scalar>& x) {
        using std::sqrt;
        constexpr double load = 6000, length = 14, young = 30e6, shear = 12e6;
        const Scalar &h = x[0], &l = x[1], &t = x[2], &b = x[3];
        const Scalar primary = load / (sqrt2 * h * l);
        const Scalar radius = sqrt(l * l / 4.0 + square(Scalar((h + t) / 2.0)));
        const Scalar polar = 2.0 * sqrt2 * h * l * (l * l / 12.0 + square(Scalar((h + t) / 2.0)));
        const Scalar secondary = load * (length + l / 2.0) * radius / polar;
        const Scalar stress =
            sqrt(primary * primary + primary * secondary * l / radius + secondary * secondary);
        const Scalar buckling = 4.013 * young / (6 * length * length) * t * b * b * b *
                                (1.0 - t / (2 * length) * std::sqrt(young / (4 * shear)));
        return std::array<Scalar, 7>{
            stress / 13600.0 - 1.0,
            6 * load * length / (b * t * t) / 30000.0 - 1.0,
            h - b,
            0.10471 * h * h + 0.04811 * t * b * (14.0 + l) - 5.0,
            0.125 - h,
            4 * load * length * length * length / (young * t * t * t * b) / 0.25 - 1.0,
            1.0 - buckling / load};
      });
}

Problem pressure_vessel() {
  return from_formulas(
      design_of("pressure-vessel", design, Vector{{0.0625, 0.0625, 10, 10}},
                Vector{{6.1875, 6.1875, 200, 200}}, 5885.332773616458,
                Vector{{0.778168641375, 0.384649162628, 40.319618724099, 200}},
                "published: 5885.3328, with any thickness; all but the last constraint are active"),
      []<class Scalar>(const Point<Scalar>& x) {
        return Scalar(0.6224 * x[0] * x[2] * x[3] + 1.7781 * x[1] * x[2] * x[2] +
                      3.1661 * x[0] * x[0] * x[3] + 19.84 * x[0] * x[0] * x[2]);
      },
      []<class Scalar>(const Point<Scalar>& x) {
        const Scalar volume = pi * x[2] * x[2] * (x[3] + 4.0 / 3 * x[2]);
        return std::array<Scalar, 3>{-x[0] + 0.0193 * x[2], -x[1] + 0.00954 * x[2],
                                     1.0 - volume / 1296000.0};
      });
}

Problem speed_reducer() {
  return from_formulas(
      design_of(
          "speed-reducer",
          "Golinski (1973), doi 10.1016/0094-114X(73)90059-6, as in Mezura-Montes and "
          "Coello (2005)",
          Vector{{2.6, 0.7, 17, 7.3, 7.3, 2.9, 5}}, Vector{{3.6, 0.8, 28, 8.3, 8.3, 3.9, 5.5}},
          2994.4710661468202,
          Vector{{3.5, 0.7, 17, 7.3, 7.715319911478244, 3.350214666096447, 5.286654464980222}},
          "published: 2994.471066; digits by Newton's method"),
      []<class Scalar>(const Point<Scalar>& x) {
        return Scalar(0.7854 * x[0] * x[1] * x[1] *
                          (3.3333 * x[2] * x[2] + 14.9334 * x[2] - 43.0934) -
                      1.508 * x[0] * (x[5] * x[5] + x[6] * x[6]) +
                      7.4777 * (x[5] * x[5] * x[5] + x[6] * x[6] * x[6]) +
                      0.7854 * (x[3] * x[5] * x[5] + x[4] * x[6] * x[6]));
      },
      []<class Scalar>(const Point<Scalar>& x) {
        using std::sqrt;
        const Scalar teeth = x[0] * x[1] * x[1] * x[2];
        const auto shaft = [&](const Scalar& length, double constant, const Scalar& diameter,
                               double allowed) {
          return Scalar(sqrt(square(Scalar(745.0 * length / (x[1] * x[2]))) + constant) /
                            (allowed * diameter * diameter * diameter) -
                        1.0);
        };
        return std::array<Scalar, 11>{
            27.0 / teeth - 1.0,
            397.5 / (teeth * x[2]) - 1.0,
            1.93 * x[3] * x[3] * x[3] / (x[1] * x[2] * x[5] * x[5] * x[5] * x[5]) - 1.0,
            1.93 * x[4] * x[4] * x[4] / (x[1] * x[2] * x[6] * x[6] * x[6] * x[6]) - 1.0,
            shaft(x[3], 16.9e6, x[5], 110),
            shaft(x[4], 157.5e6, x[6], 85),
            x[1] * x[2] / 40.0 - 1.0,
            5.0 * x[1] / x[0] - 1.0,
            x[0] / (12.0 * x[1]) - 1.0,
            (1.5 * x[5] + 1.9) / x[3] - 1.0,
            (1.1 * x[6] + 1.9) / x[4] - 1.0};
      });
}

Problem spring() {
  return from_formulas(
      design_of("spring", design, Vector{{0.05, 0.25, 2}}, Vector{{2, 1.3, 15}},
                0.012665232788319417,
                Vector{{0.05168906109161388, 0.35671774001235873, 11.288965739130628}},
                "published: 0.0126652; digits by Newton's method"),
      []<class Scalar>(const Point<Scalar>& x) {
        return Scalar((x[2] + 2.0) * x[1] * x[0] * x[0]);
      },
      []<class Scalar>(const Point<Scalar>& x) {
        const Scalar &d = x[0], &coil = x[1], &turns = x[2];
        const Scalar d3 = d * d * d;
        return std::array<Scalar, 4>{
            1.0 - coil * coil * coil * turns / (71785.0 * d3 * d),
            (4.0 * coil * coil - d * coil) / (12566.0 * (coil * d3 - d3 * d)) +
                1.0 / (5108.0 * d * d) - 1.0,
            1.0 - 140.45 * d / (coil * coil * turns), (d + coil) / 1.5 - 1.0};
      });
}

Problem three_bar_truss() {
  return from_formulas(
      design_of("three-bar-truss", "Ray and Saini (2001), doi 10.1080/03052150108940941",
                Vector::Constant(2, 0.01), Vector::Ones(2), 100 * sqrt2 + 50 * std::sqrt(6.0),
                Vector{{0.5 + std::sqrt(3.0) / 6, 1 / std::sqrt(6.0)}},
                "closed form; published: 263.895843"),
      []<class Scalar>(const Point<Scalar>& x) {
        return Scalar(100.0 * (2 * sqrt2 * x[0] + x[1]));
      },
      []<class Scalar>(const Point<Scalar>& x) {
        const Scalar area = sqrt2 * x[0] * x[0] + 2.0 * x[0] * x[1];
        return std::array<Scalar, 3>{2.0 * (sqrt2 * x[0] + x[1]) / area - 2.0,
                                     2.0 * x[1] / area - 2.0, 2.0 / (x[0] + sqrt2 * x[1]) - 2.0};
      });
}

Problem cantilever() {
  // Lagrange: each x_i is proportional to the fourth root of its coefficient.
  static constexpr std::array<double, 5> weights = {61, 37, 19, 7, 1};
  double sum = 0;
  for (const double w : weights) sum += std::pow(w, 0.25);
  Vector best(5);
  for (Eigen::Index i = 0; i < 5; ++i) {
    best[i] = std::pow(weights[static_cast<std::size_t>(i)], 0.25) * std::cbrt(sum);
  }
  return from_formulas(
      design_of("cantilever",
                "Chickermane and Gea (1996), doi "
                "10.1002/(SICI)1097-0207(19960315)39:5<829::AID-NME884>3.0.CO;2-U",
                Vector::Constant(5, 0.5), Vector::Constant(5, 50), 0.0624 * best.sum(), best,
                "closed form, by Lagrange multipliers"),
      []<class Scalar>(const Point<Scalar>& x) { return Scalar(0.0624 * x.sum()); },
      []<class Scalar>(const Point<Scalar>& x) {
        Scalar total(-1);
        for (Eigen::Index i = 0; i < x.size(); ++i) {
          total += weights[static_cast<std::size_t>(i)] / (x[i] * x[i] * x[i]);
        }
        return std::array<Scalar, 1>{total};
      });
}

Problem pooling() {
  // Haverly's first: bought A, B and C (to x and to y), pooled P (to x and to y) of sulphur p.
  Vector upper = Vector::Constant(9, 300);
  upper[6] = 3;
  upper[7] = 100;
  upper[8] = 200;
  Vector lower = Vector::Zero(9);
  lower[6] = 1;
  Problem problem = from_formulas(
      design_of("pooling", "Haverly (1978), doi 10.1145/1111237.1111238", lower, upper, -400,
                Vector{{0, 100, 0, 100, 0, 100, 1, 0, 200}}, "published: -400, proven since"),
      []<class Scalar>(const Point<Scalar>& x) {
        return Scalar(6.0 * x[0] + 16.0 * x[1] + 10.0 * (x[2] + x[3]) - 9.0 * x[7] - 15.0 * x[8]);
      },
      []<class Scalar>(const Point<Scalar>& x) {
        return std::array<Scalar, 6>{x[4] + x[5] - x[0] - x[1],
                                     x[7] - x[4] - x[2],
                                     x[8] - x[5] - x[3],
                                     x[6] * (x[4] + x[5]) - 3.0 * x[0] - x[1],
                                     x[6] * x[4] + 2.0 * x[2] - 2.5 * x[7],
                                     x[6] * x[5] + 2.0 * x[3] - 1.5 * x[8]};
      });
  problem.equalities = 4;
  return problem;
}

}  // namespace

std::vector<Problem> constrained_problems() {
  return {g01(),           g03(),         g06(),
          g08(),           g11(),         g21(),
          g24(),           welded_beam(), pressure_vessel(),
          speed_reducer(), spring(),      three_bar_truss(),
          cantilever(),    pooling()};
}

}  // namespace ricochet::held_out
