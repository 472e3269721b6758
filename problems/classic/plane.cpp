#include "problems/classic/plane.h"

#include <cmath>
#include <numbers>

#include "problems/classic/formula.h"

namespace ricochet::classic {
namespace {

using std::numbers::pi;

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

}  // namespace ricochet::classic
