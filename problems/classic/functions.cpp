#include "problems/classic/functions.h"

#include <array>
#include <cmath>
#include <numbers>

#include "problems/classic/formula.h"
#include "problems/classic/hock_schittkowski.h"

namespace ricochet::classic {

namespace {

using std::numbers::e;
using std::numbers::pi;

}  // namespace

Problem rastrigin(Eigen::Index n) {
  return from_formula(nonnegative("rastrigin",
                                  "Rastrigin's function: Muehlenbein, Schomisch and Born (1991), "
                                  "doi 10.1016/S0167-8191(05)80052-3",
                                  -3.072, 5.12, Vector::Zero(n)),
                      []<class Scalar>(const Point<Scalar>& x) {
                        using std::cos;
                        Scalar sum(0);
                        for (const Scalar& t : x) sum += t * t + 10.0 * (1.0 - cos(2 * pi * t));
                        return sum;
                      });
}

Problem ackley(Eigen::Index n) {
  return from_formula(
      nonnegative(
          "ackley",
          "Ackley's function: Ackley (1987), doi 10.1007/978-1-4613-1997-9, for n variables",
          -19.6608, 32.768, Vector::Zero(n)),
      []<class Scalar>(const Point<Scalar>& x) {
        using std::cos;
        using std::exp;
        using std::sqrt;
        const auto count = static_cast<double>(x.size());
        const Scalar squares = x.squaredNorm();
        if (squares == 0.0) return Scalar(0);
        Scalar waves(0);
        for (const Scalar& t : x) waves += cos(2 * pi * t);
        return 20.0 * (1.0 - exp(-0.2 * sqrt(squares / count))) + (e - exp(waves / count));
      });
}

Problem griewank(Eigen::Index n) {
  return from_formula(
      nonnegative("griewank", "Griewank's function: Griewank (1981), doi 10.1007/BF00933356", -360,
                  600, Vector::Zero(n)),
      []<class Scalar>(const Point<Scalar>& x) {
        using std::cos;
        Scalar product(1);
        for (Eigen::Index i = 0; i < x.size(); ++i) {
          product *= cos(x[i] / std::sqrt(static_cast<double>(i + 1)));
        }
        return x.squaredNorm() / 4000.0 + (1.0 - product);
      });
}

Problem levy(Eigen::Index n) {
  return from_formula(
      nonnegative("levy", "Levy's function: Levy and Montalvo (1985), doi 10.1137/0906002", -10, 10,
                  Vector::Ones(n)),
      []<class Scalar>(const Point<Scalar>& x) {
        using std::sin;
        // pi is subtracted from the first sine's argument and 2 pi from the last's: exactly 0 at
        // the optimum.
        const Eigen::Index last = x.size() - 1;
        const Scalar first_wave = sin(pi * (x[0] - 1.0) / 4.0);
        Scalar sum = first_wave * first_wave;
        for (Eigen::Index i = 0; i < x.size(); ++i) {
          const Scalar off = (x[i] - 1.0) / 4.0;
          const Scalar wave = i < last ? sin(pi * (1.0 + off) + 1.0) : sin(2 * pi * off);
          sum += off * off * (1.0 + (i < last ? 10.0 : 1.0) * wave * wave);
        }
        return sum;
      });
}

Problem styblinski_tang(Eigen::Index n) {
  // The smallest root of the derivative 2 x^3 - 16 x + 5/2, by the formula for cubics.
  const double root = 2 * std::sqrt(8.0 / 3) *
                      std::cos(std::acos(-15.0 / 64 * std::sqrt(3.0 / 8)) / 3 - 4 * pi / 3);
  Statement styblinski = nonnegative("styblinski-tang",
                                     "Styblinski and Tang's function: Styblinski and Tang (1990), "
                                     "doi 10.1016/0893-6080(90)90029-K",
                                     -5, 5, Vector::Constant(n, root));
  styblinski.best_known = static_cast<double>(n) * root * (root * (root * root - 16) + 5) / 2;
  styblinski.provenance = "closed form: the lowest root of a cubic, in every coordinate";
  return from_formula(styblinski, []<class Scalar>(const Point<Scalar>& x) {
    Scalar sum(0);
    for (const Scalar& t : x) sum += 0.5 * t * (t * (t * t - 16.0) + 5.0);
    return sum;
  });
}

Problem schwefel_2_26(Eigen::Index n) {
  Statement schwefel = nonnegative(
      "schwefel-2.26", "Schwefel (1981), Numerical optimization of computer models, 2.26", -500,
      500, Vector::Constant(n, 420.96874635998199));
  schwefel.start = Vector::Constant(n, -100);
  schwefel.best_known = -418.98288727243371 * static_cast<double>(n);
  schwefel.provenance = "closed form: x = z^2 with tan z = -z / 2 near z = 20.5";
  schwefel.rotates = false;
  return from_formula(schwefel, []<class Scalar>(const Point<Scalar>& x) {
    using std::abs;
    using std::sin;
    using std::sqrt;
    Scalar sum(0);
    for (const Scalar& t : x) {
      if (t != 0.0) sum -= t * sin(sqrt(abs(t)));  // at 0 the value and the slope are 0
    }
    return sum;
  });
}

Problem sphere(Eigen::Index n) {
  return from_formula(
      nonnegative("sphere",
                  "sphere function: De Jong (1975), An analysis of the behavior of a "
                  "class of genetic adaptive systems, F1",
                  -60, 100, Vector::Zero(n)),
      []<class Scalar>(const Point<Scalar>& x) { return x.squaredNorm(); });
}

Problem ellipsoid(Eigen::Index n) {
  return from_formula(nonnegative("ellipsoid",
                                  "ellipsoid of condition 10^6: Hansen and Ostermeier (2001), "
                                  "doi 10.1162/106365601750190398",
                                  -60, 100, Vector::Zero(n)),
                      []<class Scalar>(const Point<Scalar>& x) {
                        const auto last = static_cast<double>(x.size() - 1);
                        Scalar sum(0);
                        for (Eigen::Index i = 0; i < x.size(); ++i) {
                          sum += std::pow(1e6, static_cast<double>(i) / last) * x[i] * x[i];
                        }
                        return sum;
                      });
}

Problem rosenbrock(Eigen::Index n) {
  Statement rosenbrock = nonnegative(
      "rosenbrock", "Rosenbrock's banana valley: Rosenbrock (1960), doi 10.1093/comjnl/3.3.175", -5,
      10, Vector::Ones(n));
  for (Eigen::Index i = 0; i < n; ++i) rosenbrock.start[i] = i % 2 == 0 ? -1.2 : 1.0;
  return from_formula(rosenbrock, []<class Scalar>(const Point<Scalar>& x) {
    Scalar sum(0);
    for (Eigen::Index i = 0; i + 1 < x.size(); ++i) {
      const Scalar across = x[i + 1] - x[i] * x[i];
      const Scalar along = 1.0 - x[i];
      sum += 100.0 * across * across + along * along;
    }
    return sum;
  });
}

Problem zakharov(Eigen::Index n) {
  return from_formula(
      nonnegative("zakharov",
                  "Zakharov's function: Jamil and Yang (2013), doi 10.1504/IJMMNO.2013.055204, 173",
                  -5, 10, Vector::Zero(n)),
      []<class Scalar>(const Point<Scalar>& x) {
        Scalar weighted(0);
        for (Eigen::Index i = 0; i < x.size(); ++i) {
          weighted += 0.5 * static_cast<double>(i + 1) * x[i];
        }
        const Scalar square = weighted * weighted;
        return x.squaredNorm() + square + square * square;
      });
}

Problem dixon_price(Eigen::Index n) {
  // Every x_i is 2^-(1 - 2^(1-i)): then 2 x_i^2 = x_{i-1}.
  Vector best(n);
  for (Eigen::Index i = 0; i < n; ++i) best[i] = std::exp2(std::exp2(static_cast<double>(-i)) - 1);
  return from_formula(nonnegative("dixon-price",
                                  "Dixon and Price's function: Jamil and Yang (2013), "
                                  "doi 10.1504/IJMMNO.2013.055204, 48",
                                  -10, 10, best),
                      []<class Scalar>(const Point<Scalar>& x) {
                        Scalar sum = (x[0] - 1.0) * (x[0] - 1.0);
                        for (Eigen::Index i = 1; i < x.size(); ++i) {
                          const Scalar across = 2.0 * x[i] * x[i] - x[i - 1];
                          sum += static_cast<double>(i + 1) * across * across;
                        }
                        return sum;
                      });
}

Problem schwefel_1_2(Eigen::Index n) {
  return from_formula(
      nonnegative("schwefel-1.2",
                  "double sum: Schwefel (1981), Numerical optimization of computer models, 1.2",
                  -60, 100, Vector::Zero(n)),
      []<class Scalar>(const Point<Scalar>& x) {
        Scalar sum(0);
        Scalar so_far(0);
        for (Eigen::Index i = 0; i < x.size(); ++i) {
          so_far += x[i];
          sum += so_far * so_far;
        }
        return sum;
      });
}

Problem powell_singular() {
  Statement powell = nonnegative(
      "powell-singular", "Powell's singular function: Powell (1962), doi 10.1093/comjnl/5.2.147",
      -4, 5, Vector::Zero(4));
  powell.start = Vector{{3, -1, 0, 1}};
  return from_formula(powell, []<class Scalar>(const Point<Scalar>& x) {
    const Scalar a = x[0] + 10.0 * x[1];
    const Scalar b = x[2] - x[3];
    const Scalar c = (x[1] - 2.0 * x[2]) * (x[1] - 2.0 * x[2]);
    const Scalar d = (x[0] - x[3]) * (x[0] - x[3]);
    return a * a + 5.0 * b * b + c * c + 10.0 * d * d;
  });
}

Problem step(Eigen::Index n) {
  Problem problem = without_functions(
      nonnegative("step", "step function: Yao, Liu and Lin (1999), doi 10.1109/4235.771163, f6",
                  -60, 100, Vector::Zero(n)));
  problem.jumps = true;
  problem.evaluate = [](const Vector& x) {
    return Values{(x.array() + 0.5).floor().square().sum(), {}};
  };
  return problem;
}

namespace {

Statement statement(const char* name, const char* source, Vector lower, Vector upper, Vector start,
                    double best_known, Vector best_point) {
  return {.name = name,
          .source = source,
          .lower = std::move(lower),
          .upper = std::move(upper),
          .start = std::move(start),
          .best_known = best_known,
          .best_point = std::move(best_point),
          .provenance = "closed form",
          .rotates = true};
}

}  // namespace

Problem beale() {
  return from_formula(
      statement("classic-beale",
                "Beale's function: More, Garbow and Hillstrom (1981), doi 10.1145/355934.355936, 5",
                Vector{{-4.5, -4.5}}, Vector{{4.5, 4.5}}, Vector{{1, 1}}, 0, Vector{{3, 0.5}}),
      []<class Scalar>(const Point<Scalar>& x) {
        Scalar sum(0);
        Scalar power(1);
        for (const double c : {1.5, 2.25, 2.625}) {
          power *= x[1];
          const Scalar r = c - x[0] * (1.0 - power);
          sum += r * r;
        }
        return sum;
      });
}

Problem booth() {
  return from_formula(
      statement("classic-booth",
                "Booth's function: Jamil and Yang (2013), doi 10.1504/IJMMNO.2013.055204, 17",
                Vector{{-10, -10}}, Vector{{10, 10}}, Vector{{-6, -6}}, 0, Vector{{1, 3}}),
      []<class Scalar>(const Point<Scalar>& x) {
        const Scalar a = x[0] + 2.0 * x[1] - 7.0;
        const Scalar b = 2.0 * x[0] + x[1] - 5.0;
        return a * a + b * b;
      });
}

Problem himmelblau() {
  return from_formula(
      statement("classic-himmelblau",
                "Himmelblau's function: Himmelblau (1972), Applied Nonlinear Programming",
                Vector{{-6, -6}}, Vector{{6, 6}}, Vector{{-1, -1}}, 0, Vector{{3, 2}}),
      []<class Scalar>(const Point<Scalar>& x) {
        const Scalar a = x[0] * x[0] + x[1] - 11.0;
        const Scalar b = x[0] + x[1] * x[1] - 7.0;
        return a * a + b * b;
      });
}

Problem goldstein_price() {
  return from_formula(
      statement("classic-goldstein-price",
                "Goldstein and Price's function: Goldstein and Price (1971), "
                "doi 10.1090/S0025-5718-1971-0312365-X",
                Vector{{-2, -2}}, Vector{{2, 2}}, Vector{{1, 1}}, 3, Vector{{0, -1}}),
      []<class Scalar>(const Point<Scalar>& x) {
        const Scalar s = x[0] + x[1];
        const Scalar t = 2.0 * x[0] - 3.0 * x[1];
        const Scalar first = 1.0 + (s + 1.0) * (s + 1.0) * (s * (3.0 * s - 14.0) + 19.0);
        const Scalar second = 30.0 + t * t * (t * (3.0 * t - 16.0) + 18.0);
        return first * second;
      });
}

Problem branin() {
  return from_formula(
      statement("classic-branin", "Branin's function: Branin (1972), doi 10.1147/rd.165.0504",
                Vector{{-5, 0}}, Vector{{10, 15}}, Vector{{5, 10}}, 5 / (4 * pi),
                Vector{{pi, 2.275}}),
      []<class Scalar>(const Point<Scalar>& x) {
        using std::cos;
        const Scalar off = x[1] - 5.1 / (4 * pi * pi) * x[0] * x[0] + 5 / pi * x[0] - 6.0;
        return off * off + 10 / (8 * pi) + 10 * (1 - 1 / (8 * pi)) * (1.0 + cos(x[0]));
      });
}

Problem six_hump_camel() {
  Statement camel =
      statement("classic-six-hump-camel",
                "six-hump camel back: Dixon and Szegoe (1978), Towards Global Optimisation 2, 1-15",
                Vector{{-3, -2}}, Vector{{3, 2}}, Vector{{2, -1.5}}, -1.0316284534898774,
                Vector{{0.089842013100318058, -0.71265640302073963}});
  camel.provenance = "published: -1.0316285; digits by Newton's method";
  return from_formula(camel, []<class Scalar>(const Point<Scalar>& x) {
    const Scalar a = x[0] * x[0];
    const Scalar b = x[1] * x[1];
    return (4.0 - 2.1 * a + a * a / 3.0) * a + x[0] * x[1] + (4.0 * b - 4.0) * b;
  });
}

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
