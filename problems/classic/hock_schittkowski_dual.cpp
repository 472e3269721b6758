#include <array>

#include "problems/classic/hock_schittkowski.h"
#include "problems/classic/hock_schittkowski_statement.h"

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

}  // namespace ricochet::classic
