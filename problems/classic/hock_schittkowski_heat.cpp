#include <array>
#include <cmath>
#include <numbers>

#include "problems/classic/hock_schittkowski.h"
#include "problems/classic/hock_schittkowski_statement.h"

namespace ricochet::classic {
namespace {

constexpr int terms = 30;

/// The terms of the heat equation's solution for its k-th eigenvalue, mu tan mu = 1.
struct Mode {
  double mu;
  double sine;       ///< mu sin mu
  double moment;     ///< 2 (sin mu / mu - cos mu) / mu^2
  double amplitude;  ///< 2 sin mu / (mu + sin mu cos mu)
};

std::array<Mode, terms> modes() {
  std::array<Mode, terms> result{};
  for (int k = 0; k < terms; ++k) {
    // mu is the fixed point of a contraction; the slope is -1 / (1 + mu^2).
    double mu = k * std::numbers::pi + 0.9;
    for (int i = 0; i < 100; ++i) mu = k * std::numbers::pi + std::atan(1 / mu);
    const double s = std::sin(mu);
    const double c = std::cos(mu);
    result[static_cast<std::size_t>(k)] = {mu, mu * s, 2 * (s / mu - c) / (mu * mu),
                                           2 * s / (mu + s * c)};
  }
  return result;
}

/// Problems 88 to 92: a rod is heated and cooled alternately, n times; the squared error of its
/// final temperature must be at most 1e-4. Only the squares of x matter and, if an x is 0, only the
/// sum of its neighbours' squares: there are many solutions.
Problem heated_rod(int number, Eigen::Index n) {
  Vector start(n);
  for (Eigen::Index i = 0; i < n; ++i) start[i] = i % 2 == 0 ? 0.5 : -0.5;
  Vector best = Vector::Zero(n);
  best[0] = 1.0743187312033136;
  best[n % 2 == 0 ? n - 1 : 1] = -0.4566137083747312;
  return from_formulas(
      hock_schittkowski(
          number, "", Vector::Constant(n, -10), Vector::Constant(n, 10), start,
          {1.3626568148900216, best, "published: 1.36265681; digits by Newton's method"}),
      []<class Scalar>(const Point<Scalar>& x) { return x.squaredNorm(); },
      [modes = modes(), n]<class Scalar>(const Point<Scalar>& x) {
        using std::exp;
        Scalar error(2.0 / 15 - 1e-4);
        for (const Mode& mode : modes) {
          const double square_of_mu = mode.mu * mode.mu;
          Scalar time(0.0);  // from the k-th switch to the end
          Scalar heat(n % 2 == 0 ? 1.0 : -1.0);
          for (Eigen::Index k = n - 1; k >= 0; --k) {
            time += x[k] * x[k];
            const double turned = k == 0 ? 1 : k % 2 == 0 ? 2 : -2;
            heat += turned * exp(-square_of_mu * time);
          }
          heat /= -square_of_mu;
          error += square_of_mu * mode.amplitude * heat * (mode.sine * heat - mode.moment);
        }
        return error;
      });
}

Problem hs_88() {
  return heated_rod(88, 2);
}

Problem hs_89() {
  return heated_rod(89, 3);
}

Problem hs_90() {
  return heated_rod(90, 4);
}

Problem hs_91() {
  return heated_rod(91, 5);
}

Problem hs_92() {
  return heated_rod(92, 6);
}

}  // namespace

std::vector<Problem> hock_schittkowski_heat() {
  return {hs_88(), hs_89(), hs_90(), hs_91(), hs_92()};
}

}  // namespace ricochet::classic
