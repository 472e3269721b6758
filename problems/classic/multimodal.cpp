#include "problems/classic/multimodal.h"

#include <cmath>
#include <numbers>

#include "problems/classic/nonnegative_statement.h"

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

}  // namespace ricochet::classic
