#include <cmath>
#include <numbers>

#include "problems/held_out/held_out.h"

namespace ricochet::held_out {

namespace {

using namespace classic;
using std::numbers::pi;

constexpr const char* collection =
    "Andrei (2008), An unconstrained optimization test functions "
    "collection, Advanced Modeling and Optimization 10";
constexpr const char* more = "More, Garbow and Hillstrom (1981), doi 10.1145/355934.355936";
constexpr const char* no_negative = "closed form: no term is negative";

/// From its usual start, in a box that holds start and best point; rotated with all of R^n where
/// the best point is best everywhere.
Statement function(const char* name, const char* source, double lower, double upper, Vector start,
                   double best, Vector best_point, const char* provenance) {
  const Eigen::Index n = start.size();
  return stated("outside-smooth", name, source, Vector::Constant(n, lower),
                Vector::Constant(n, upper), std::move(start), best, std::move(best_point),
                provenance);
}

template <class Scalar>
Scalar square(const Scalar& t) {
  return t * t;
}

Problem trid() {
  Vector best(10);
  for (Eigen::Index i = 0; i < 10; ++i) best[i] = static_cast<double>((i + 1) * (10 - i));
  return from_formula(
      function("trid-10", "Jamil and Yang (2013), doi 10.1504/IJMMNO.2013.055204", -60, 100,
               Vector::Constant(10, 68), -210, best, "closed form: -n (n + 4) (n - 1) / 6"),
      []<class Scalar>(const Point<Scalar>& x) {
        Scalar sum(0);
        for (Eigen::Index i = 0; i < x.size(); ++i) {
          sum += square(Scalar(x[i] - 1.0));
          if (i > 0) sum -= x[i] * x[i - 1];
        }
        return sum;
      });
}

Problem broyden_tridiagonal() {
  return from_formula(
      function(
          "broyden-tridiagonal-10", more, -10, 10, Vector::Constant(10, -1), 0,
          Vector{{-0.5707221320112248, -0.681806949984275, -0.7022100760176601, -0.7055106298950804,
                  -0.7049061557287437, -0.7014966070298512, -0.6918893223547983,
                  -0.6657965144058537, -0.5960351090263657, -0.4164122575286934}},
          "closed form: no term is negative, and all are 0 there"),
      []<class Scalar>(const Point<Scalar>& x) {
        Scalar sum(0);
        const Eigen::Index n = x.size();
        for (Eigen::Index i = 0; i < n; ++i) {
          Scalar r = (3.0 - 2.0 * x[i]) * x[i] + 1.0;
          if (i > 0) r -= x[i - 1];
          if (i + 1 < n) r -= 2.0 * x[i + 1];
          sum += square(r);
        }
        return sum;
      });
}

Problem penalty_1() {
  Vector start(10);
  for (Eigen::Index i = 0; i < 10; ++i) start[i] = static_cast<double>(i + 1);
  return from_formula(function("penalty-1-10", more, -20, 20, start, 7.08765146709037e-5,
                               Vector::Constant(10, 0.15812230111311634),
                               "published: 7.08765e-5; digits by Newton's method"),
                      []<class Scalar>(const Point<Scalar>& x) {
                        Scalar sum = square(Scalar(x.squaredNorm() - 0.25));
                        for (const Scalar& t : x) sum += 1e-5 * square(Scalar(t - 1.0));
                        return sum;
                      });
}

Problem variably_dimensioned() {
  Vector start(10);
  for (Eigen::Index i = 0; i < 10; ++i) start[i] = 1 - static_cast<double>(i + 1) / 10;
  return from_formula(
      function("variably-dimensioned-10", more, -10, 10, start, 0, Vector::Ones(10), no_negative),
      []<class Scalar>(const Point<Scalar>& x) {
        Scalar sum(0), weighted(0);
        for (Eigen::Index i = 0; i < x.size(); ++i) {
          sum += square(Scalar(x[i] - 1.0));
          weighted += static_cast<double>(i + 1) * (x[i] - 1.0);
        }
        return Scalar(sum + square(weighted) + square(square(weighted)));
      });
}

Problem trigonometric() {
  return from_formula(
      function("trigonometric-5", more, -3, 5, Vector::Constant(5, 0.2), 0, Vector::Zero(5),
               no_negative),
      []<class Scalar>(const Point<Scalar>& x) {
        using std::cos;
        using std::sin;
        const Eigen::Index n = x.size();
        Scalar cosines(0), sum(0);
        for (const Scalar& t : x) cosines += cos(t);
        for (Eigen::Index i = 0; i < n; ++i) {
          sum += square(Scalar(static_cast<double>(n) - cosines +
                               static_cast<double>(i + 1) * (1.0 - cos(x[i])) - sin(x[i])));
        }
        return sum;
      });
}

Problem boundary_value() {
  constexpr Eigen::Index n = 10;
  Vector start(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double t = static_cast<double>(i + 1) / static_cast<double>(n + 1);
    start[i] = t * (t - 1);
  }
  return from_formula(
      function("boundary-value-10", more, -2, 3, start, 0,
               Vector{{-0.04316498251876487, -0.08157715653538689, -0.11448571438052929,
                       -0.14097357686259668, -0.1599086961819831, -0.16987720231277492,
                       -0.16908998378120835, -0.15524953522183182, -0.125355891678935,
                       -0.07541653368589209}},
               "closed form: no term is negative, and all are 0 there"),
      []<class Scalar>(const Point<Scalar>& x) {
        Scalar sum(0);
        const Eigen::Index size = x.size();
        const double h = 1.0 / static_cast<double>(size + 1);
        for (Eigen::Index i = 0; i < size; ++i) {
          const Scalar t = x[i] + (static_cast<double>(i + 1) * h + 1.0);
          Scalar r = 2.0 * x[i] + h * h * t * t * t / 2.0;
          if (i > 0) r -= x[i - 1];
          if (i + 1 < size) r -= x[i + 1];
          sum += square(r);
        }
        return sum;
      });
}

Problem chained_wood() {
  Vector start(8);
  start << -3, -1, -3, -1, -2, 0, -2, 0;
  return from_formula(
      function("chained-wood-8", collection, -10, 10, start, 0, Vector::Ones(8), no_negative),
      []<class Scalar>(const Point<Scalar>& x) {
        Scalar sum(0);
        for (Eigen::Index i = 0; i + 3 < x.size(); i += 2) {
          const Scalar a = x[i + 1] - x[i] * x[i], b = x[i + 3] - x[i + 2] * x[i + 2];
          sum += 100.0 * a * a + square(Scalar(1.0 - x[i])) + 90.0 * b * b +
                 square(Scalar(1.0 - x[i + 2])) + 10.0 * square(Scalar(x[i + 1] + x[i + 3] - 2.0)) +
                 0.1 * square(Scalar(x[i + 1] - x[i + 3]));
        }
        return sum;
      });
}

Problem nondia() {
  return from_formula(function("nondia-10", collection, -5, 5, Vector::Constant(10, -1), 0,
                               Vector::Ones(10), no_negative),
                      []<class Scalar>(const Point<Scalar>& x) {
                        Scalar sum = square(Scalar(x[0] - 1.0));
                        for (Eigen::Index i = 1; i < x.size(); ++i) {
                          sum += 100.0 * square(Scalar(x[0] - x[i - 1] * x[i - 1]));
                        }
                        // As printed, the last variable does not occur; here it does.
                        return Scalar(sum + square(Scalar(x[x.size() - 1] - 1.0)));
                      });
}

Problem engval_1() {
  return from_formula(
      function("engval-1-10", collection, -5, 5, Vector::Constant(10, 2), 9.177469957181389,
               Vector{{0.9010300773537779, 0.5458806318363335, 0.651211024767828,
                       0.6240699289748367, 0.631966912896528, 0.6278006754942878,
                       0.6365631942282387, 0.605290716534446, 0.717030185519927, 0}},
               "convex; digits by Newton's method"),
      []<class Scalar>(const Point<Scalar>& x) {
        Scalar sum(0);
        for (Eigen::Index i = 0; i + 1 < x.size(); ++i) {
          sum += square(Scalar(x[i] * x[i] + x[i + 1] * x[i + 1])) - 4.0 * x[i] + 3.0;
        }
        return sum;
      });
}

Problem dqdrtic() {
  return from_formula(function("dqdrtic-10", collection, -6, 10, Vector::Constant(10, 3), 0,
                               Vector::Zero(10), no_negative),
                      []<class Scalar>(const Point<Scalar>& x) {
                        Scalar sum(0);
                        for (Eigen::Index i = 0; i + 2 < x.size(); ++i) {
                          sum += x[i] * x[i] + 100.0 * x[i + 1] * x[i + 1] +
                                 100.0 * x[i + 2] * x[i + 2];
                        }
                        return sum;
                      });
}

Problem tridia() {
  Vector best(20);
  for (Eigen::Index i = 0; i < 20; ++i) best[i] = std::ldexp(1.0, -static_cast<int>(i));
  return from_formula(
      function("tridia-20", collection, -5, 5, Vector::Ones(20), 0, best, no_negative),
      []<class Scalar>(const Point<Scalar>& x) {
        Scalar sum = square(Scalar(x[0] - 1.0));
        for (Eigen::Index i = 1; i < x.size(); ++i) {
          sum += static_cast<double>(i + 1) * square(Scalar(2.0 * x[i] - x[i - 1]));
        }
        return sum;
      });
}

Problem cosine() {
  const double best = (0.5 + std::sqrt(0.25 + 4 * pi)) / 2;  // x^2 - x / 2 = pi
  return from_formula(function("cosine-10", collection, -5, 5, Vector::Ones(10), -9,
                               Vector::Constant(10, best), "closed form: each cosine is -1"),
                      []<class Scalar>(const Point<Scalar>& x) {
                        using std::cos;
                        Scalar sum(0);
                        for (Eigen::Index i = 0; i + 1 < x.size(); ++i) {
                          sum += cos(x[i] * x[i] - 0.5 * x[i + 1]);
                        }
                        return sum;
                      });
}

Problem arwhead() {
  Vector best = Vector::Ones(20);
  best[19] = 0;
  return from_formula(
      function("arwhead-20", collection, -5, 5, Vector::Ones(20), 0, best,
               "closed form: t^4 - 4 t + 3 is least at 1, and the last variable only adds"),
      []<class Scalar>(const Point<Scalar>& x) {
        const Scalar& last = x[x.size() - 1];
        Scalar sum(0);
        for (Eigen::Index i = 0; i + 1 < x.size(); ++i) {
          sum += square(Scalar(x[i] * x[i] + last * last)) - 4.0 * x[i] + 3.0;
        }
        return sum;
      });
}

Problem quartc() {
  Vector best(10);
  for (Eigen::Index i = 0; i < 10; ++i) best[i] = static_cast<double>(i + 1);
  return from_formula(
      function("quartc-10", collection, -20, 30, Vector::Constant(10, 2), 0, best, no_negative),
      []<class Scalar>(const Point<Scalar>& x) {
        Scalar sum(0);
        for (Eigen::Index i = 0; i < x.size(); ++i) {
          sum += square(square(Scalar(x[i] - static_cast<double>(i + 1))));
        }
        return sum;
      });
}

}  // namespace

std::vector<Problem> smooth_problems() {
  return {trid(),          broyden_tridiagonal(),
          penalty_1(),     variably_dimensioned(),
          trigonometric(), boundary_value(),
          chained_wood(),  nondia(),
          engval_1(),      dqdrtic(),
          tridia(),        cosine(),
          arwhead(),       quartc()};
}

}  // namespace ricochet::held_out
