#include <algorithm>
#include <array>
#include <cmath>

#include "problems/classic/benchmark.h"
#include "problems/classic/least_squares_functions.h"

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

}  // namespace ricochet::classic
