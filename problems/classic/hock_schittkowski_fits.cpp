#include <array>
#include <cmath>

#include "problems/classic/hock_schittkowski.h"
#include "problems/classic/hock_schittkowski_statement.h"

namespace ricochet::classic {
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

}  // namespace ricochet::classic
