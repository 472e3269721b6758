#include "problems/carrier_track/scene/contact_law.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace ricochet::carrier_track::inline scene {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double epsilon = std::numeric_limits<double>::epsilon();

void require_restitution(bool holds, double restitution, const char* allowed) {
  if (!holds) {
    throw std::invalid_argument(
        fmt::format("restitution = {}: must be within {}", restitution, allowed));
  }
}

/// (x - ln(1 + x)) / x^2, without cancellation. With it the restitution e of D obeys
/// g(D) = e^2 g(-e D), and the deepest penetration is proportional to g(D).
double scaled_excess(double x) {
  if (std::abs(x) > 0.2) return (x - std::log1p(x)) / (x * x);
  // 1/2 - x/3 + x^2/4 - ...; the first term left out is below 1e-17.
  double sum = 0;
  for (int k = 24; k >= 2; --k) sum = 1.0 / k - x * sum;
  return sum;
}

/// A function with a root, and its derivative.
struct Residual {
  double value, slope;
};

/// Finds the root of a residual by Newton's method from a start close to it; stops when the steps
/// are below rounding.
template <class Function>
double newton(double x, Function residual) {
  for (int i = 0; i < 50; ++i) {
    const auto [value, slope] = residual(x);
    const double step = value / slope;
    x -= step;
    if (!(std::abs(step) > 2 * epsilon * std::abs(x))) break;
  }
  return x;
}

double exact_dissipation(double e) {
  if (e == 1) return 0;
  if (e > 0.9) {
    // Close to D = 0, a root for every e, the equation, divided by D^2, is the series sum over k >=
    // 2 of (-D)^(k-2) (1 - (-e)^k) / k.
    return newton(1.5 * (1 - e * e) / (1 + e * e * e), [e](double d) {
      Residual sum{0.5 * (1 - e) * (1 + e), 0};
      double power = -e * e * e;  // (-e)^k
      double minus_d = 1;         // (-d)^(k-3)
      for (int k = 3; k <= 26; ++k) {
        const double term = minus_d * (1 - power) / k;
        sum.value -= d * term;
        sum.slope -= (k - 2) * term;
        power *= -e;
        minus_d *= -d;
      }
      return sum;
    });
  }
  // Solve for y with D = (1 - y) / e: this keeps all digits where D is close to its bound 1 / e.
  const double inverse = 1 + 1 / e;
  const double start = inverse * std::exp(-inverse);
  if (start < 0.1 * epsilon) return 1 / e;
  const double y = newton(start, [e, inverse](double x) {
    return Residual{(1 - x) * inverse - std::log((1 + e - x) / (e * x)),
                    -inverse + 1 / (1 + e - x) + 1 / x};
  });
  return (1 - y) / e;
}

/// -ln of the restitution that the Kelvin-Voigt law returns.
double logarithmic_loss(double z, Release release) {
  const double square = (1 - z) * (1 + z);
  if (release == Release::zero_depth) {
    return square > 0 ? std::numbers::pi * z / std::sqrt(square) : infinity;
  }
  if (square == 0) return 2;
  return 2 * z *
         (square > 0 ? std::acos(z) / std::sqrt(square) : std::acosh(z) / std::sqrt(-square));
}

}  // namespace

bool needs_restitution(ContactLaw law) {
  return law == ContactLaw::kelvin_voigt || law == ContactLaw::flores ||
         law == ContactLaw::gonthier || law == ContactLaw::exact_restitution;
}

double dissipation(ContactLaw law, double restitution) {
  const double c = restitution;
  require_restitution(c >= 0 && c <= 1, c, "0..1");
  if (needs_restitution(law)) require_restitution(c > 0, c, "0..1, without 0");
  switch (law) {
    case ContactLaw::hertz:
      return 0;
    case ContactLaw::kelvin_voigt:
      break;
    case ContactLaw::hunt_crossley:
      return 1.5 * (1 - c);
    case ContactLaw::lankarani_nikravesh:
      return 0.75 * (1 - c * c);
    case ContactLaw::zhiying_qishao:
      return 0.75 * (1 - c * c) * std::exp(2 * (1 - c));
    case ContactLaw::flores:
      return 1.6 * (1 - c) / c;
    case ContactLaw::gonthier:
      return (1 - c * c) / c;
    case ContactLaw::exact_restitution:
      return exact_dissipation(c);
  }
  throw std::invalid_argument("kelvin-voigt has a damping ratio, no dissipation factor");
}

double returned_restitution(double dissipation) {
  const double d = dissipation;
  if (d == 0) return 1;
  if (d < 1) {
    const double goal = d * d * scaled_excess(d);
    const double eta = newton(d / (1 + 2 * d / 3), [goal](double x) {
      return Residual{x * x * scaled_excess(-x) - goal, x / (1 - x)};
    });
    return eta / d;
  }
  // x - ln x has the same value at x = 1 - e D and x = 1 + D.
  const double goal = 1 + d - std::log1p(d);
  const double start = std::exp(-goal);
  if (start < 0.1 * epsilon) return 1 / d;
  const double y = newton(start, [goal](double x) {
    return Residual{x - std::log(x) - goal, 1 - 1 / x};
  });
  return (1 - y) / d;
}

double peak_penetration(double stiffness, double exponent, double mass, double speed,
                        double dissipation) {
  return std::pow((exponent + 1) * mass / stiffness * speed * speed * scaled_excess(dissipation),
                  1 / (exponent + 1));
}

double kelvin_voigt_restitution(double damping_ratio, Release release) {
  return std::exp(-logarithmic_loss(damping_ratio, release));
}

double damping_ratio(double restitution, Release release) {
  require_restitution(restitution > 0 && restitution <= 1, restitution, "0..1, without 0");
  const double loss = -std::log(restitution);
  if (release == Release::zero_depth) return loss / std::hypot(loss, std::numbers::pi);
  // The loss increases with z without bound: it is pi z for small z and 2 ln(2 z) for large z.
  double lower = loss / std::numbers::pi;
  double upper = lower;
  while (logarithmic_loss(upper, release) < loss) upper = 2 * upper;
  while (upper - lower > 2 * epsilon * upper) {
    const double middle = lower + 0.5 * (upper - lower);
    if (middle <= lower || middle >= upper) break;
    (logarithmic_loss(middle, release) < loss ? lower : upper) = middle;
  }
  return upper;
}

double damping_factor(ContactLaw law, double restitution) {
  return law == ContactLaw::kelvin_voigt ? damping_ratio(restitution, Release::zero_force)
                                         : dissipation(law, restitution);
}

}  // namespace ricochet::carrier_track::inline scene
