#include <array>
#include <cmath>

#include "problems/classic/hock_schittkowski.h"

namespace ricochet::classic {

namespace {

/// The data of problem 86 and of its dual, 117: minimise e x + x C x + d x^3 subject to A x >= b.
/// a_24 is 0.4, as in the authors' programs; others have 4, which does not change either optimum.
struct Data {
  Eigen::Matrix<double, 10, 5> a;
  Eigen::Matrix<double, 10, 1> b;
  Eigen::Matrix<double, 5, 5> c;
  Eigen::Matrix<double, 5, 1> d, e;
};

Data data() {
  Data data;
  data.a << -16, 2, 0, 1, 0,  //
      0, -2, 0, 0.4, 2,       //
      -3.5, 0, 2, 0, 0,       //
      0, -2, 0, -4, -1,       //
      0, -9, -2, 1, -2.8,     //
      2, 0, -4, 0, 0,         //
      -1, -1, -1, -1, -1,     //
      -1, -2, -3, -2, -1,     //
      1, 2, 3, 4, 5,          //
      1, 1, 1, 1, 1;
  data.b << -40, -2, -0.25, -4, -4, -1, -40, -60, 5, 1;
  data.c << 30, -20, -10, 32, -10,  //
      -20, 39, -6, -31, 32,         //
      -10, -6, 10, -6, -10,         //
      32, -31, -6, 39, -20,         //
      -10, 32, -10, -20, 30;
  data.d << 4, 8, 10, 6, 2;
  data.e << -15, -27, -36, -18, -12;
  return data;
}

Problem hs_86() {
  Vector start = Vector::Zero(5);
  start[4] = 1;
  return from_formulas(
      hock_schittkowski(86, "", Vector::Zero(5), Vector::Constant(5, 10), start,
                        {-32.348678965722705,
                         Vector{{0.2999999999999999, 0.33346760653460705, 0.3999999999999999,
                                 0.42831010478169895, 0.2239648735607982}},
                         "published: -32.34867897; digits by Newton's method"}),
      [data = data()]<class Scalar>(const Point<Scalar>& x) {
        Scalar sum(0.0);
        for (Eigen::Index j = 0; j < 5; ++j) {
          sum += x[j] * (data.e[j] + data.d[j] * x[j] * x[j]);
          for (Eigen::Index i = 0; i < 5; ++i) sum += data.c(i, j) * x[i] * x[j];
        }
        return sum;
      },
      [data = data()]<class Scalar>(const Point<Scalar>& x) {
        Point<Scalar> result(10);
        for (Eigen::Index i = 0; i < 10; ++i) {
          result[i] = Scalar(data.b[i]);
          for (Eigen::Index j = 0; j < 5; ++j) result[i] -= data.a(i, j) * x[j];
        }
        return result;
      });
}

/// x_1 to x_10 are the multipliers of problem 86, the others are its x.
Problem hs_117() {
  Vector start = Vector::Constant(15, 1e-3);
  start[6] = 60;
  return from_formulas(
      hock_schittkowski(
          117, "", Vector::Zero(15), Vector::Constant(15, 100), start,
          {32.34867896572274,
           Vector{{0, 0, 5.174040727698179, 0, 3.0611086877584492, 11.839545664800742, 0, 0,
                   0.10389619077061478, 0, 0.30000000000000016, 0.3334676065346073,
                   0.39999999999999986, 0.42831010478169873, 0.22396487356079808}},
           "published: 32.34867897; digits by Newton's method"}),
      [data = data()]<class Scalar>(const Point<Scalar>& x) {
        Scalar sum(0.0);
        for (Eigen::Index i = 0; i < 10; ++i) sum -= data.b[i] * x[i];
        for (Eigen::Index j = 0; j < 5; ++j) {
          sum += 2.0 * data.d[j] * cubed(x[10 + j]);
          for (Eigen::Index i = 0; i < 5; ++i) sum += data.c(i, j) * x[10 + i] * x[10 + j];
        }
        return sum;
      },
      [data = data()]<class Scalar>(const Point<Scalar>& x) {
        Point<Scalar> result(5);
        for (Eigen::Index j = 0; j < 5; ++j) {
          result[j] = -data.e[j] - 3.0 * data.d[j] * x[10 + j] * x[10 + j];
          for (Eigen::Index i = 0; i < 5; ++i) result[j] -= 2.0 * data.c(i, j) * x[10 + i];
          for (Eigen::Index i = 0; i < 10; ++i) result[j] += data.a(i, j) * x[i];
        }
        return result;
      });
}

}  // namespace

std::vector<Problem> hock_schittkowski_dual() {
  return {hs_86(), hs_117()};
}

namespace {

Problem hs_25() {
  return from_formula(
      hock_schittkowski(25, "", Vector{{0.1, 0, 0}}, Vector{{100, 25.6, 5}}, Vector{{100, 12.5, 3}},
                        {0, Vector{{50, 25, 1.5}}, in_closed_form}),
      []<class Scalar>(const Point<Scalar>& x) {
        using std::exp, std::pow;
        Scalar sum(0.0);
        for (int i = 1; i <= 99; ++i) {
          const double u = 25 + std::pow(-50 * std::log(0.01 * i), 2.0 / 3);
          sum += square(exp(-pow(u - x[1], x[2]) / x[0]) - 0.01 * i);
        }
        return sum;
      });
}

Problem hs_57() {
  constexpr std::array<double, 44> place = {
      8,  8,  10, 10, 10, 10, 12, 12, 12, 12, 14, 14, 14, 16, 16, 16, 18, 18, 20, 20, 20, 22,
      22, 22, 24, 24, 24, 26, 26, 26, 28, 28, 30, 30, 30, 32, 32, 34, 36, 36, 38, 38, 40, 42};
  constexpr std::array<double, 44> observed = {
      0.49, 0.49, 0.48, 0.47, 0.48, 0.47, 0.46, 0.46, 0.45, 0.43, 0.45, 0.43, 0.43, 0.44, 0.43,
      0.43, 0.46, 0.45, 0.42, 0.42, 0.43, 0.41, 0.41, 0.40, 0.42, 0.40, 0.40, 0.41, 0.40, 0.41,
      0.41, 0.40, 0.40, 0.40, 0.38, 0.41, 0.40, 0.40, 0.41, 0.38, 0.40, 0.40, 0.39, 0.39};
  return from_formulas(
      hock_schittkowski(57, "", Vector{{0.4, -4}}, Vector{{10, 10}}, Vector{{0.42, 5}},
                        {0.028459669722986716, Vector{{0.41995265075780125, 1.284845193624846}},
                         "published: 0.02845966972; digits by Newton's method"}),
      [=]<class Scalar>(const Point<Scalar>& x) {
        using std::exp;
        Scalar sum(0.0);
        for (std::size_t i = 0; i < place.size(); ++i) {
          sum += square(observed[i] - x[0] - (0.49 - x[0]) * exp(-x[1] * (place[i] - 8.0)));
        }
        return sum;
      },
      []<class Scalar>(const Point<Scalar>& x) { return 0.09 - 0.49 * x[1] + x[0] * x[1]; });
}

/// Flow of water down a river.
Problem hs_70() {
  constexpr std::array<double, 19> observed = {
      0.00189, 0.1038, 0.268, 0.506, 0.577, 0.604,  0.725,  0.898,   0.947,  0.845,
      0.702,   0.528,  0.385, 0.257, 0.159, 0.0869, 0.0453, 0.01509, 0.00189};
  return from_formulas(
      hock_schittkowski(
          70, "", Vector::Constant(4, 1e-5), Vector{{100, 100, 1, 100}}, Vector{{2, 4, 0.04, 2}},
          {0.007498463574427607,
           Vector{{12.276979127629124, 4.63174816285486, 0.3128646302256918, 2.0292828253414883}},
           "published: 0.007498464; digits by Newton's method"}),
      [observed]<class Scalar>(const Point<Scalar>& x) {
        using std::exp, std::pow, std::sqrt;
        const Scalar b = x[2] + (1.0 - x[2]) * x[3];
        // One of the two waves, with this share and shape, at time t.
        const auto wave = [](const Scalar& share, const Scalar& shape, const Scalar& rate,
                             double t) {
          return Scalar(share * pow(rate, shape) * sqrt(shape / 6.2832) * pow(t, shape - 1.0) *
                        exp(shape - rate * t * shape) * (12.0 * shape / (12.0 * shape + 1.0)));
        };
        Scalar sum(0.0);
        for (std::size_t i = 0; i < observed.size(); ++i) {
          const double t = (i == 0 ? 0.1 : static_cast<double>(i)) / 7.658;
          sum += square(wave(x[2], x[1], b, t) + wave(1.0 - x[2], x[0], b / x[3], t) - observed[i]);
        }
        return sum;
      },
      []<class Scalar>(const Point<Scalar>& x) { return Scalar(-x[2] - (1.0 - x[2]) * x[3]); });
}

/// The likelihood of 235 values under a mixture of three normal distributions. The last two values
/// are 260, as in the authors' programs; others have 250.
Problem hs_105() {
  struct Counted {
    int times;
    double value;
  };
  constexpr std::array<Counted, 30> data = {
      {{1, 95},   {1, 105},  {4, 110},  {4, 115}, {15, 120}, {15, 125}, {15, 130}, {13, 135},
       {21, 140}, {12, 145}, {17, 150}, {4, 155}, {20, 160}, {8, 165},  {17, 170}, {8, 175},
       {6, 180},  {6, 185},  {7, 190},  {4, 195}, {3, 200},  {3, 205},  {8, 210},  {1, 215},
       {6, 220},  {5, 230},  {1, 235},  {7, 240}, {1, 245},  {2, 260}}};
  return from_formulas(
      hock_schittkowski(
          105, "", Vector{{0.001, 0.001, 100, 130, 170, 5, 5, 5}},
          Vector{{0.499, 0.499, 180, 210, 240, 25, 25, 25}},
          Vector{{0.1, 0.2, 100, 125, 175, 11.2, 13.2, 15.8}},
          {1138.4106636721308,
           Vector{{0.397111320748623, 0.4270396426387567, 130.89648260431576, 163.89480252353377,
                   218.68461532296675, 12.159066207739238, 16.61630167696296, 20.0192020654133}},
           "published: 1138.416240, near the minimum; digits by Newton's method"}),
      [data]<class Scalar>(const Point<Scalar>& x) {
        using std::exp, std::log;
        const auto density = [](const Scalar& share, const Scalar& middle, const Scalar& spread,
                                double value) {
          return Scalar(share / spread * exp(-square(value - middle) / (2.0 * spread * spread)));
        };
        Scalar sum(0.0);
        for (const auto& [times, y] : data) {
          const Scalar all = density(x[0], x[2], x[5], y) + density(x[1], x[3], x[6], y) +
                             density(1.0 - x[0] - x[1], x[4], x[7], y);
          sum -= static_cast<double>(times) * log(all / std::sqrt(2 * std::acos(-1.0)));
        }
        return sum;
      },
      []<class Scalar>(const Point<Scalar>& x) { return x[0] + x[1] - 1.0; });
}

}  // namespace

std::vector<Problem> hock_schittkowski_fits() {
  return {hs_25(), hs_57(), hs_70(), hs_105()};
}

namespace {

/// The objective of problems 101 to 103; the last two constraints keep it between 100 and 3000.
template <class Scalar>
Scalar four_terms(const Point<Scalar>& x, double power) {
  using std::pow, std::sqrt;
  return 10.0 * x[0] * x[3] * x[3] * pow(x[6], power) / (x[1] * cubed(x[5])) +
         15.0 * x[2] * x[3] / (x[0] * x[1] * x[1] * x[4] * sqrt(x[6])) +
         20.0 * x[1] * x[5] / (x[0] * x[0] * x[3] * x[4] * x[4]) +
         25.0 * square(x[0] * x[1]) * sqrt(x[4]) * x[6] / (x[2] * x[5] * x[5]);
}

/// The terms of problems 101 to 103 that must be at most 1.
template <class Scalar>
std::array<Scalar, 4> sums_of_terms(const Point<Scalar>& x) {
  using std::cbrt, std::pow, std::sqrt;
  const Scalar quarter = pow(x[6], 0.25);
  const Scalar third = cbrt(x[6]);
  const Scalar half = sqrt(x[6]);
  const Scalar first = 0.5 * sqrt(x[0]) * x[6] / (x[2] * x[5] * x[5]) +
                       0.7 * cubed(x[0]) * x[1] * x[5] * half / (x[2] * x[2]) +
                       0.2 * x[2] * square(cbrt(x[5])) * quarter / (x[1] * sqrt(x[3]));
  const Scalar second = 1.3 * x[1] * x[5] / (sqrt(x[0]) * x[2] * x[4]) +
                        0.8 * x[2] * x[5] * x[5] / (x[3] * x[4]) +
                        3.1 * sqrt(x[1]) * cbrt(x[5]) / (x[0] * x[3] * x[3] * x[4]);
  const Scalar sum = 2.0 * x[0] * x[4] * third / (x[2] * sqrt(x[2]) * x[5]) +
                     0.1 * x[1] * x[4] / (sqrt(x[2] * x[6]) * x[5]) +
                     x[1] * sqrt(x[2]) * x[4] / x[0] +
                     0.65 * x[2] * x[4] * x[6] / (x[1] * x[1] * x[5]);
  const Scalar fourth =
      0.2 * x[1] * sqrt(x[4]) * third / (x[0] * x[0] * x[3]) +
      0.3 * sqrt(x[0]) * x[1] * x[1] * x[2] * cbrt(x[3]) * quarter / square(cbrt(x[4])) +
      0.4 * x[2] * x[4] * half * quarter / (cubed(x[0]) * x[1] * x[1]) +
      0.5 * x[3] * half / (x[2] * x[2]);
  return {first, second, sum, fourth};
}

/// Problems 101 to 103.
Problem geometric(int number, double power, Optimum optimum) {
  Vector lower = Vector::Constant(7, 0.1);
  lower[6] = 0.01;
  return from_formulas(
      hock_schittkowski(number, "", lower, Vector::Constant(7, 10), Vector::Constant(7, 6),
                        std::move(optimum)),
      [power]<class Scalar>(const Point<Scalar>& x) { return four_terms(x, power); },
      [power]<class Scalar>(const Point<Scalar>& x) {
        const std::array<Scalar, 4> sums = sums_of_terms(x);
        const Scalar cost = four_terms(x, power);
        return std::array<Scalar, 6>{sums[0] - 1.0, sums[1] - 1.0, sums[2] - 1.0,
                                     sums[3] - 1.0, 100.0 - cost,  cost - 3000.0};
      });
}

Problem hs_101() {
  return geometric(
      101, -0.25,
      {1809.764765571413,
       Vector{{2.856158555755148, 0.6108230308034505, 2.1508125621644734, 4.712873709241235,
               0.9994875408574648, 1.347507504828332, 0.03165276650277431}},
       "published: 1809.76476; digits by Newton's method"});
}

Problem hs_102() {
  return geometric(
      102, 0.125,
      {911.8805714301099,
       Vector{{3.8962531910702807, 0.8093587601054141, 2.6643859937754897, 4.300912874794019,
               0.8535549352485835, 1.0952874445761025, 0.027310459657719253}},
       "published: 911.880571; digits by Newton's method"});
}

Problem hs_103() {
  return geometric(
      103, 0.5,
      {543.6679584662812,
       Vector{{4.3941045105264065, 0.8544687387974245, 2.843230313950895, 3.3999786676865593,
               0.7229261330073024, 0.870406381804457, 0.024638826327228507}},
       "published: 543.667958; digits by Newton's method"});
}

/// Two reactors.
Problem hs_104() {
  constexpr auto cost = []<class Scalar>(const Point<Scalar>& x) {
    using std::pow;
    return Scalar(0.4 * pow(x[0] / x[6], 0.67) + 0.4 * pow(x[1] / x[7], 0.67) + 10.0 - x[0] - x[1]);
  };
  return from_formulas(
      hock_schittkowski(
          104, "", Vector::Constant(8, 0.1), Vector::Constant(8, 10),
          Vector{{6, 3, 0.4, 0.2, 6, 6, 1, 0.5}},
          {3.951163440103356,
           Vector{{6.465114028369099, 2.23270864798523, 0.6673974912866294, 0.595756422900371,
                   5.932675677909848, 5.527234564976938, 1.0133220089025616, 0.40066822912570316}},
           "published: 3.9511634396; digits by Newton's method"}),
      cost, [cost]<class Scalar>(const Point<Scalar>& x) {
        using std::pow;
        const Scalar spent = cost(x);
        return std::array<Scalar, 6>{0.0588 * x[4] * x[6] + 0.1 * x[0] - 1.0,
                                     0.0588 * x[5] * x[7] + 0.1 * x[0] + 0.1 * x[1] - 1.0,
                                     4.0 * x[2] / x[4] + 2.0 / (pow(x[2], 0.71) * x[4]) +
                                         0.0588 * x[6] / pow(x[2], 1.3) - 1.0,
                                     4.0 * x[3] / x[5] + 2.0 / (pow(x[3], 0.71) * x[5]) +
                                         0.0588 * x[7] / pow(x[3], 1.3) - 1.0,
                                     1.0 - spent,
                                     spent - 4.2};
      });
}

}  // namespace

std::vector<Problem> hock_schittkowski_geometric() {
  return {hs_101(), hs_102(), hs_103(), hs_104()};
}

}  // namespace ricochet::classic
