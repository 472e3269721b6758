#include "problems/classic/unimodal.h"

#include <cmath>

#include "problems/classic/nonnegative_statement.h"

namespace ricochet::classic {
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
  problem.evaluate = [](const Vector& x) {
    return Values{(x.array() + 0.5).floor().square().sum(), {}};
  };
  return problem;
}

}  // namespace ricochet::classic
