#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "problems/classic/classic.h"
#include "problems/classic/least_squares.h"

namespace ricochet::classic {

Problem bard(double scale) {
  // If x_2 or x_3 is negative, it has poles and a valley to infinity.
  return least_squares(
      {.name = "bard",
       .origin = more_garbow_hillstrom(8),
       .start = Vector::Ones(3),
       .best_sum = 0.0082148773065789868,
       .best_point = Vector{{0.082410559749788878, 1.1330360920297207, 2.343695178642538}},
       .provenance = published,
       .rotates = false},
      scale, []<class Scalar>(const Point<Scalar>& x) {
        constexpr std::array y = {0.14, 0.18, 0.22, 0.25, 0.29, 0.32, 0.35, 0.39,
                                  0.37, 0.58, 0.73, 0.96, 1.34, 2.10, 4.39};
        std::array<Scalar, y.size()> r;
        for (std::size_t i = 0; i < y.size(); ++i) {
          const auto u = static_cast<double>(i + 1);
          const double v = 16 - u;
          r[i] = y[i] - (x[0] + u / (v * x[1] + std::min(u, v) * x[2]));
        }
        return r;
      });
}

Problem kowalik_osborne() {
  // If x_3 or x_4 is negative, it has poles and a valley to infinity.
  return least_squares({.name = "kowalik-osborne",
                        .origin = more_garbow_hillstrom(15),
                        .start = Vector{{0.25, 0.39, 0.415, 0.39}},
                        .best_sum = 0.00030750560384923875,
                        .best_point = Vector{{0.19280693457903789, 0.19128232873436685,
                                              0.12305650692632081, 0.13606233068379475}},
                        .provenance = published,
                        .rotates = false},
                       1, []<class Scalar>(const Point<Scalar>& x) {
                         constexpr std::array u = {4.0,   2.0, 1.0,    0.5,    0.25,  0.167,
                                                   0.125, 0.1, 0.0833, 0.0714, 0.0625};
                         constexpr std::array y = {0.1957, 0.1947, 0.1735, 0.1600, 0.0844, 0.0627,
                                                   0.0456, 0.0342, 0.0323, 0.0235, 0.0246};
                         std::array<Scalar, y.size()> r;
                         for (std::size_t i = 0; i < y.size(); ++i) {
                           r[i] =
                               y[i] - x[0] * u[i] * (u[i] + x[1]) / (u[i] * (u[i] + x[2]) + x[3]);
                         }
                         return r;
                       });
}

Problem meyer() {
  // The box keeps the temperature 45 + 5 i + x_3 above 0 and the exponential finite.
  return least_squares(
      {.name = "meyer",
       .origin = more_garbow_hillstrom(10),
       .start = Vector{{0.02, 4000, 250}},
       .best_sum = 87.945855170851121,
       .best_point = Vector{{0.0056096364710280525, 6181.3463462863723, 345.2236346241365}},
       .provenance = published,
       .rotates = false,
       .lower = Vector{{-10, 0, 0}},
       .upper = Vector{{10, 15000, 4000}}},
      1, []<class Scalar>(const Point<Scalar>& x) {
        using std::exp;
        constexpr std::array y = {34780.0, 28610.0, 23650.0, 19630.0, 16370.0, 13720.0,
                                  11540.0, 9744.0,  8261.0,  7030.0,  6005.0,  5147.0,
                                  4427.0,  3820.0,  3307.0,  2872.0};
        std::array<Scalar, y.size()> r;
        for (std::size_t i = 0; i < y.size(); ++i) {
          r[i] = x[0] * exp(x[1] / (50.0 + 5.0 * static_cast<double>(i) + x[2])) - y[i];
        }
        return r;
      });
}

Problem box_3d() {
  return least_squares({.name = "box-3d",
                        .origin = more_garbow_hillstrom(12),
                        .start = Vector{{0, 10, 20}},
                        .best_sum = 0,
                        .best_point = Vector{{1, 10, 1}},
                        .provenance = all_zero},
                       1, []<class Scalar>(const Point<Scalar>& x) {
                         using std::exp;
                         std::array<Scalar, 10> r;
                         for (std::size_t i = 0; i < r.size(); ++i) {
                           const double t = static_cast<double>(i + 1) / 10;
                           r[i] = exp(-t * x[0]) - exp(-t * x[1]) -
                                  x[2] * (std::exp(-t) - std::exp(-10 * t));
                         }
                         return r;
                       });
}

Problem jennrich_sampson() {
  return least_squares({.name = "jennrich-sampson",
                        .origin = more_garbow_hillstrom(6),
                        .start = Vector{{0.3, 0.4}},
                        .best_sum = 124.36218235561483,
                        .best_point = Vector{{0.2578252136703641, 0.2578252136703641}},
                        .provenance = published},
                       1, []<class Scalar>(const Point<Scalar>& x) {
                         using std::exp;
                         std::array<Scalar, 10> r;
                         for (std::size_t k = 0; k < r.size(); ++k) {
                           const auto i = static_cast<double>(k + 1);
                           r[k] = 2.0 + 2.0 * i - (exp(i * x[0]) + exp(i * x[1]));
                         }
                         return r;
                       });
}

Problem brown_dennis(double scale) {
  return least_squares({.name = "brown-dennis",
                        .origin = more_garbow_hillstrom(16),
                        .start = Vector{{25, 5, -5, -1}},
                        .best_sum = 85822.201626356342,
                        .best_point = Vector{{-11.594439904762163, 13.203630051207202,
                                              -0.4034394881768596, 0.23677877445573628}},
                        .provenance = published},
                       scale, []<class Scalar>(const Point<Scalar>& x) {
                         std::array<Scalar, 20> r;
                         for (std::size_t i = 0; i < r.size(); ++i) {
                           const double t = static_cast<double>(i + 1) / 5;
                           const Scalar a = x[0] + t * x[1] - std::exp(t);
                           const Scalar b = x[2] + std::sin(t) * x[3] - std::cos(t);
                           r[i] = a * a + b * b;
                         }
                         return r;
                       });
}

Problem osborne_1() {
  // Rates below 0 would overflow: at a rate of -1, 32 steps of 10 give exp(320). The start is that
  // of More and Wild; the collection has -1 as its third coordinate.
  return least_squares(
      {.name = "osborne-1",
       .origin = more_garbow_hillstrom(17),
       .start = Vector{{0.5, 1.5, 1, 0.01, 0.02}},
       .best_sum = 5.4648946974831195e-05,
       .best_point = Vector{{0.37541005210695161, 1.9358469127123203, -1.4646871366133756,
                             0.012867534640057189, 0.022122699661672789}},
       .provenance = published,
       .rotates = false,
       .lower = Vector{{-20, -20, -20, -0.5, -0.5}},
       .upper = Vector{{20, 20, 20, 1, 1}}},
      1, []<class Scalar>(const Point<Scalar>& x) {
        using std::exp;
        constexpr std::array y = {0.844, 0.908, 0.932, 0.936, 0.925, 0.908, 0.881, 0.850, 0.818,
                                  0.784, 0.751, 0.718, 0.685, 0.658, 0.628, 0.603, 0.580, 0.558,
                                  0.538, 0.522, 0.506, 0.490, 0.478, 0.467, 0.457, 0.448, 0.438,
                                  0.431, 0.424, 0.420, 0.414, 0.411, 0.406};
        std::array<Scalar, y.size()> r;
        for (std::size_t i = 0; i < y.size(); ++i) {
          const double t = 10 * static_cast<double>(i);
          r[i] = y[i] - (x[0] + x[1] * exp(-t * x[3]) + x[2] * exp(-t * x[4]));
        }
        return r;
      });
}

Problem osborne_2(double scale) {
  // Rates and steepnesses below 0 would overflow.
  return least_squares(
      {.name = "osborne-2",
       .origin = more_garbow_hillstrom(19),
       .start = Vector{{1.3, 0.65, 0.65, 0.7, 0.6, 3, 5, 7, 2, 4.5, 5.5}},
       .best_sum = 0.04013773629354777,
       .best_point = Vector{{1.3099771546273005, 0.43155379460298898, 0.63366169896072411,
                             0.59943053478591635, 0.75418322632801138, 0.90428857985963362,
                             1.3658118352370285, 4.8236988172271564, 2.3986848661317546,
                             4.5688745976676719, 5.6753414705806415}},
       .provenance = published,
       .rotates = false,
       .lower = Vector{{-100, -100, -100, -100, 0, 0, 0, 0, -100, -100, -100}},
       .upper = Vector::Constant(11, 100)},
      scale, []<class Scalar>(const Point<Scalar>& x) {
        using std::exp;
        constexpr std::array y = {
            1.366, 1.191, 1.112, 1.013, 0.991, 0.885, 0.831, 0.847, 0.786, 0.725, 0.746,
            0.679, 0.608, 0.655, 0.616, 0.606, 0.602, 0.626, 0.651, 0.724, 0.649, 0.649,
            0.694, 0.644, 0.624, 0.661, 0.612, 0.558, 0.533, 0.495, 0.500, 0.423, 0.395,
            0.375, 0.372, 0.391, 0.396, 0.405, 0.428, 0.429, 0.523, 0.562, 0.607, 0.653,
            0.672, 0.708, 0.633, 0.668, 0.645, 0.632, 0.591, 0.559, 0.597, 0.625, 0.739,
            0.710, 0.729, 0.720, 0.636, 0.581, 0.428, 0.292, 0.162, 0.098, 0.054};
        std::array<Scalar, y.size()> r;
        for (std::size_t i = 0; i < y.size(); ++i) {
          const double t = static_cast<double>(i) / 10;
          r[i] = y[i] - x[0] * exp(-t * x[4]);
          for (int peak = 1; peak <= 3; ++peak) {
            const Scalar off = t - x[7 + peak];
            r[i] -= x[peak] * exp(-x[4 + peak] * off * off);
          }
        }
        return r;
      });
}

namespace {

/// A published optimum without a formula.
struct Found {
  double sum;
  Vector point;
};

using FoundByDimension = std::map<Eigen::Index, Found>;

}  // namespace

Problem watson(Eigen::Index n, double scale) {
  static const FoundByDimension found = {
      {6,
       {0.0022876700535524519,
        Vector{{-0.015725086401458588, 1.0124348693691099, -0.23299162595673742, 1.2604300877996066,
                -1.5137289227222768, 0.99299643243113289}}}},
      {9,
       {1.3997601381003787e-06,
        Vector{{-1.5307036521410398e-05, 0.99978970393194821, 0.014763963693562875,
                0.1463423282993031, 1.0008211030049619, -2.6177311405195689, 4.1044031644795052,
                -3.1436122785568279, 1.0526264080102581}}}},
      {12,
       {4.7223811049538479e-10,
        Vector{{-6.6380604648008865e-09, 1.0000016441178621, -0.00056393221037715695,
                0.34782054050484601, -0.15673150410399017, 1.0528151772484144, -3.2472711535899301,
                7.2884348981959501, -10.27184824164417, 9.0741136473224717, -4.54137546679849,
                1.0120118885722713}}}},
  };
  return least_squares({.name = "watson",
                        .origin = more_garbow_hillstrom(20),
                        .start = Vector::Constant(n, 0.5),
                        .best_sum = found.at(n).sum,
                        .best_point = found.at(n).point,
                        .provenance = published},
                       scale, []<class Scalar>(const Point<Scalar>& x) {
                         // The polynomial y with coefficients x should satisfy y' = y^2 + 1, y(0) =
                         // 0.
                         Point<Scalar> r(31);
                         for (int i = 0; i < 29; ++i) {
                           const double t = (i + 1) / 29.0;
                           Scalar value(0);
                           Scalar slope(0);
                           for (Eigen::Index j = x.size() - 1; j >= 0; --j) {
                             slope = slope * t + value;
                             value = value * t + x[j];
                           }
                           r[i] = slope - value * value - 1.0;
                         }
                         r[29] = x[0];
                         r[30] = x[1] - x[0] * x[0] - 1.0;
                         return r;
                       });
}

Problem chebyquad(Eigen::Index n) {
  static const FoundByDimension found = {
      {6,
       {0, Vector{{0.06687659094608964, 0.2887406731194441, 0.36668229924164747, 0.6333177007583523,
                   0.7112593268805555, 0.9331234090539102}}}},
      {7,
       {0, Vector{{0.0580691496209753, 0.23517161235742137, 0.3380440947400461, 0.5,
                   0.6619559052599537, 0.7648283876425783, 0.9419308503790245}}}},
      {8,
       {0.0035168737256779346,
        Vector{{0.043152760151016607, 0.19309084038418611, 0.26632870689027294, 0.5, 0.5,
                0.73367129310972712, 0.80690915961581389, 0.95684723984898334}}}},
      {9,
       {0, Vector{{0.04420534613578318, 0.19949067230988682, 0.23561910847105574,
                   0.4160469078926057, 0.5, 0.5839530921074088, 0.7643808915289372,
                   0.800509327690123, 0.9557946538642177}}}},
      {10,
       {0.0047727136963753494,
        Vector{{0.074748166214602479, 0.17151817694809263, 0.28643415258400001, 0.35964645062893408,
                0.47075052286659347, 0.61673833503874498, 0.61673833503874498, 0.79981080153861372,
                0.84485464224092666, 0.96700662698192552}}}},
      {11,
       {0.0027997615518657506,
        Vector{{0.029958744771884895, 0.13731120691981244, 0.18836638899080266, 0.35884311738872715,
                0.35884311738872715, 0.49999999999999994, 0.64115688261127279, 0.64115688261127279,
                0.81163361100919729, 0.86268879308018753, 0.97004125522811502}}}},
  };
  return least_squares(
      {.name = "chebyquad",
       .origin = more_garbow_hillstrom(35),
       .start = Vector::LinSpaced(n, 1, static_cast<double>(n)) / static_cast<double>(n + 1),
       .best_sum = found.at(n).sum,
       .best_point = found.at(n).point,
       .provenance = published},
      1, []<class Scalar>(const Point<Scalar>& x) {
        // Means of the shifted Chebyshev polynomials on [0, 1] over the points, minus their
        // integrals.
        const Eigen::Index count = x.size();
        Point<Scalar> r = Point<Scalar>::Zero(count);
        for (const Scalar& point : x) {
          const Scalar t = 2.0 * point - 1.0;
          Scalar before(1);
          Scalar chebyshev = t;
          for (Eigen::Index i = 0; i < count; ++i) {
            r[i] += chebyshev / static_cast<double>(count);
            const Scalar next = 2.0 * t * chebyshev - before;
            before = chebyshev;
            chebyshev = next;
          }
        }
        for (Eigen::Index i = 1; i < count; i += 2) {
          const auto degree = static_cast<double>(i + 1);
          r[i] += 1.0 / (degree * degree - 1.0);
        }
        return r;
      });
}

Problem brown_almost_linear(Eigen::Index n) {
  return least_squares({.name = "brown-almost-linear",
                        .origin = more_garbow_hillstrom(27),
                        .start = Vector::Constant(n, 0.5),
                        .best_sum = 0,
                        .best_point = Vector::Ones(n),
                        .provenance = all_zero},
                       1, []<class Scalar>(const Point<Scalar>& x) {
                         const Eigen::Index last = x.size() - 1;
                         const Scalar sum = x.sum();
                         Point<Scalar> r(x.size());
                         for (Eigen::Index i = 0; i < last; ++i) {
                           r[i] = x[i] + sum - static_cast<double>(x.size() + 1);
                         }
                         r[last] = x.prod() - 1.0;
                         return r;
                       });
}

Problem bdqrtic(Eigen::Index n) {
  static const FoundByDimension found = {
      {8,
       {10.238973421317436, Vector{{0.61607544445466123, 0.48617671888000757, 0.3919029370726182,
                                    0.32635052353739552, 0, 0, 0, 0}}}},
      {10,
       {18.281161753593537,
        Vector{{0.62553647811054414, 0.48510098408564367, 0.36719434828618397, 0.28518848159393839,
                0.33016716433477289, 0.37757199004567049, 0, 0, 0, 0}}}},
      {11,
       {22.260591734883761,
        Vector{{0.62514183074953866, 0.48581960566488736, 0.37125022110390477, 0.28350401535341718,
                0.3169469727455595, 0.33873299588376476, 0.37592091004191225, 0, 0, 0, 0}}}},
      {12,
       {26.272766396793962, Vector{{0.62480036598832367, 0.48537652247283242, 0.37165912920747235,
                                    0.28597185120795776, 0.3155200175795323, 0.32537244429035578,
                                    0.33781861028965904, 0.37402022626297482, 0, 0, 0, 0}}}},
  };
  return least_squares({.name = "bdqrtic",
                        .origin = cuter,
                        .start = Vector::Ones(n),
                        .best_sum = found.at(n).sum,
                        .best_point = found.at(n).point,
                        .provenance = published},
                       1, []<class Scalar>(const Point<Scalar>& x) {
                         const Eigen::Index half = x.size() - 4;
                         const Point<Scalar> square = x.cwiseProduct(x);
                         Point<Scalar> r(2 * half);
                         for (Eigen::Index i = 0; i < half; ++i) {
                           r[i] = 3.0 - 4.0 * x[i];
                           r[half + i] = square[i] + 2.0 * square[i + 1] + 3.0 * square[i + 2] +
                                         4.0 * square[i + 3] + 5.0 * square[x.size() - 1];
                         }
                         return r;
                       });
}

Problem cube(Eigen::Index n) {
  return least_squares({.name = "cube",
                        .origin = cuter,
                        .start = Vector::Constant(n, 0.5),
                        .best_sum = 0,
                        .best_point = Vector::Ones(n),
                        .provenance = all_zero},
                       1, []<class Scalar>(const Point<Scalar>& x) {
                         Point<Scalar> r(x.size());
                         r[0] = x[0] - 1.0;
                         for (Eigen::Index i = 1; i < x.size(); ++i) {
                           r[i] = 10.0 * (x[i] - x[i - 1] * x[i - 1] * x[i - 1]);
                         }
                         return r;
                       });
}

Problem mancino(Eigen::Index n, double scale) {
  static const std::map<Eigen::Index, Vector> found = {
      {5, Vector{{84.28291101102532, 79.20603967293438, 74.3364141135311, 69.6711474112178,
                  65.20718113814442}}},
      {8, Vector{{84.43334222593528, 79.33454939399172, 74.44387011026309, 69.7592945870252,
                  65.27853533617875, 60.9988580578957, 56.9169379354432, 53.028761291567236}}},
      {10, Vector{{84.53434289477315, 79.42084435375007, 74.51601545241338, 69.81844699647671,
                   65.32637991893166, 61.03748806452533, 56.94869518846038, 53.056052319528746,
                   49.35469508461959, 45.83889035077595}}},
      {12, Vector{{84.63591921594158, 79.5076423105225, 74.5885724920863, 69.87791406833868,
                   65.37444824684921, 61.07626530788906, 56.98054088428213, 53.08338921660163,
                   49.379816810523714, 45.86378591833196, 42.52838225939789, 39.36606891417026}}},
  };
  const auto formula = []<class Scalar>(const Point<Scalar>& x) {
    using std::cos;
    using std::log;
    using std::sin;
    using std::sqrt;
    Point<Scalar> r(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      r[i] = 1400.0 * x[i] + std::pow(static_cast<double>(i - 49), 3);
      for (Eigen::Index j = 0; j < x.size(); ++j) {
        const Scalar v =
            sqrt(x[i] * x[i] + static_cast<double>(i + 1) / static_cast<double>(j + 1));
        const Scalar s = sin(log(v));
        const Scalar c = cos(log(v));
        r[i] += v * (s * s * s * s * s + c * c * c * c * c);
      }
    }
    return r;
  };
  // The standard start is a fixed multiple of the residuals at 0.
  return least_squares({.name = "mancino",
                        .origin = cuter,
                        .start = -8.710996e-4 * formula(Vector::Zero(n).eval()),
                        .best_sum = 0,
                        .best_point = found.at(n),
                        .provenance = published},
                       scale, formula);
}

}  // namespace ricochet::classic
