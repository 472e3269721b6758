#include "src/benchmark/experiment/perturbations/rounding.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>

#include "src/benchmark/experiment/perturbations/perturbed_calls.h"
#include "src/benchmark/experiment/perturbations/telling.h"

namespace ricochet {
namespace {

/// Rounds to the nearest decimal number of 6 significant digits.
void round_digits(double& number) {
  if (!std::isfinite(number)) return;
  std::array<char, 32> text;
  const auto written =
      std::to_chars(text.begin(), text.end(), number, std::chars_format::scientific, 5);
  std::from_chars(text.begin(), written.ptr, number);
}

void round_all(Eigen::Ref<Vector> values, Eigen::Ref<Matrix> slopes, Draws&) {
  for (double& value : values) round_digits(value);
  for (double& slope : slopes.reshaped()) round_digits(slope);
}

class Notches : public PerturbedCalls {
 public:
  Values values(const Problem& shown, const Vector& x) override {
    return shown.evaluate(nearest(shown, x));
  }
  Derivatives derivatives(const Problem& shown, const Vector& x) override {
    return shown.differentiate(nearest(shown, x));
  }
  Residuals residuals(const Problem& shown, const Vector& x) override {
    return shown.residuals(nearest(shown, x));
  }
  Matrix hessian(const Problem& shown, const Vector& x, double objective_factor,
                 const Vector& multipliers) override {
    return shown.lagrangian_hessian(nearest(shown, x), objective_factor, multipliers);
  }

 private:
  static Vector nearest(const Problem& shown, const Vector& x) {
    constexpr double steps = 1000;
    Vector result(x.size());
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      const double width = shown.upper[i] - shown.lower[i];
      const double place = width > 0 ? (x[i] - shown.lower[i]) / width : 0.0;
      const double notch = std::round(steps * place) / steps;
      result[i] = std::min(shown.lower[i] + notch * width, shown.upper[i]);
    }
    return result;
  }
};

}  // namespace

Perturbation truncated() {
  return {"truncated", "every number told is rounded to 6 significant digits",
          [](const Problem&) { return true; },
          [](const Problem& shown, std::uint64_t seed) {
            return told_by(round_all, Drawn::by_call, seed, shown);
          }};
}

Perturbation quantised() {
  return {"quantised",
          "evaluated at the nearest of 1001 evenly spaced values of every variable; judged is the "
          "point asked for",
          [](const Problem&) { return true; },
          [](const Problem& shown, std::uint64_t) {
            return perturbed_by(std::make_shared<Notches>(), shown);
          }};
}

}  // namespace ricochet
