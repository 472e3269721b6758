#include <array>

#include "problems/classic/formula.h"
#include "problems/classic/multimodal.h"

namespace ricochet::classic {
namespace {

/// minus the sum over i of depth_i exp(- sum over j of steepness_ij (x_j - centre_ij)^2).
Problem hartmann(Statement statement, const Matrix& steepness, const Matrix& centre) {
  const auto n = steepness.cols();
  statement.source =
      "Hartmann's function: Dixon and Szegoe (1978), Towards Global Optimisation 2, "
      "North-Holland, 1-15";
  statement.lower = Vector::Zero(n);
  statement.upper = Vector::Ones(n);
  statement.start = Vector::Constant(n, 0.5);
  // A stationary point is a weighted mean of the centres in every coordinate, so all lie in the
  // box.
  statement.rotates = true;
  return from_formula(statement, [steepness, centre]<class Scalar>(const Point<Scalar>& x) {
    using std::exp;
    constexpr std::array depth = {1.0, 1.2, 3.0, 3.2};
    Scalar sum(0);
    for (Eigen::Index i = 0; i < 4; ++i) {
      Scalar power(0);
      for (Eigen::Index j = 0; j < x.size(); ++j) {
        const Scalar off = x[j] - centre(i, j);
        power += steepness(i, j) * off * off;
      }
      sum -= depth[static_cast<std::size_t>(i)] * exp(-power);
    }
    return sum;
  });
}

}  // namespace

Problem hartmann_3() {
  return hartmann(
      {.name = "classic-hartmann-3",
       .best_known = -3.8627821478207549,
       .best_point = Vector{{0.11461433858967196, 0.55564884997185693, 0.85254695352086585}},
       .provenance = "published: -3.86278 (Dixon and Szegoe); digits by Newton's method"},
      Matrix{{3, 10, 30}, {0.1, 10, 35}, {3, 10, 30}, {0.1, 10, 35}},
      Matrix{{0.3689, 0.1170, 0.2673},
             {0.4699, 0.4387, 0.7470},
             {0.1091, 0.8732, 0.5547},
             {0.03815, 0.5743, 0.8828}});
}

Problem hartmann_6() {
  return hartmann(
      {.name = "classic-hartmann-6",
       .best_known = -3.3223680114155152,
       .best_point = Vector{{0.20168951100670543, 0.15001069182345797, 0.47687397422189698,
                             0.27533243049405609, 0.31165161660011326, 0.65730053406562039}},
       .provenance = "published: -3.32237 (Dixon and Szegoe); digits by Newton's method"},
      Matrix{{10, 3, 17, 3.5, 1.7, 8},
             {0.05, 10, 17, 0.1, 8, 14},
             {3, 3.5, 1.7, 10, 17, 8},
             {17, 8, 0.05, 10, 0.1, 14}},
      Matrix{{0.1312, 0.1696, 0.5569, 0.0124, 0.8283, 0.5886},
             {0.2329, 0.4135, 0.8307, 0.3736, 0.1004, 0.9991},
             {0.2348, 0.1451, 0.3522, 0.2883, 0.3047, 0.6650},
             {0.4047, 0.8828, 0.8732, 0.5743, 0.1091, 0.0381}});
}

Problem shekel() {
  const Statement statement = {
      .name = "classic-shekel-4",
      .source =
          "Shekel's foxholes, ten of them: Dixon and Szegoe (1978), Towards Global Optimisation 2, "
          "North-Holland, 1-15",
      .lower = Vector::Zero(4),
      .upper = Vector::Constant(4, 10),
      .start = Vector::Constant(4, 8),
      .best_known = -10.536409816692041,
      .best_point =
          Vector{{4.0007465315920463, 4.000592934138532, 3.9996633980403224, 3.9995098005868077}},
      .provenance = "published: -10.5364 (Dixon and Szegoe); digits by Newton's method",
      .rotates = true};  // a stationary point is a weighted mean of the centres
  return from_formula(statement, []<class Scalar>(const Point<Scalar>& x) {
    constexpr double centre[10][4] = {{4, 4, 4, 4}, {1, 1, 1, 1},    {8, 8, 8, 8}, {6, 6, 6, 6},
                                      {3, 7, 3, 7}, {2, 9, 2, 9},    {5, 5, 3, 3}, {8, 1, 8, 1},
                                      {6, 2, 6, 2}, {7, 3.6, 7, 3.6}};
    constexpr double width[10] = {0.1, 0.2, 0.2, 0.4, 0.4, 0.6, 0.3, 0.7, 0.5, 0.5};
    Scalar sum(0);
    for (int i = 0; i < 10; ++i) {
      Scalar square(width[i]);
      for (int j = 0; j < 4; ++j) square += (x[j] - centre[i][j]) * (x[j] - centre[i][j]);
      sum -= 1.0 / square;
    }
    return sum;
  });
}

}  // namespace ricochet::classic
