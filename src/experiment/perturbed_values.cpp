#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "src/core/time_limit.h"
#include "src/experiment/perturbations.h"

namespace ricochet {

namespace {

/// Changes a number by `share` times its size, or times 1 if that is larger.
void move(double& number, double share) {
  if (std::isfinite(number)) number += std::max(1.0, std::abs(number)) * share;
}

void add_noise(Eigen::Ref<Vector> values, Eigen::Ref<Matrix> slopes, Draws& draws) {
  constexpr double size = 1e-3;
  for (double& value : values) move(value, size * draws.normal());
  for (double& slope : slopes.reshaped()) move(slope, size * draws.normal());
}

void add_outlier(Eigen::Ref<Vector> values, Eigen::Ref<Matrix> slopes, Draws& draws) {
  constexpr double probability = 0.2;
  constexpr double size = std::numbers::pi / 2;
  if (draws.uniform() >= probability) return;
  for (double& value : values) move(value, size * std::abs(draws.cauchy()));
  for (double& slope : slopes.reshaped()) move(slope, size * draws.cauchy());
}

Perturbation told_perturbation(const std::string& name, const std::string& summary,
                               const Tell& tell, Drawn drawn) {
  return {name, summary, [](const Problem&) { return true; },
          [name, tell, drawn](const Problem& shown, std::uint64_t seed) {
            return told_by(tell, drawn, key_of(seed, name), shown);
          }};
}

}  // namespace

Perturbation noisy() {
  return told_perturbation(
      "noisy",
      "every number v told is v + 1e-3 max(1, |v|) times a normal one, another at every call",
      add_noise, Drawn::by_call);
}

Perturbation frozen_noise() {
  return told_perturbation("frozen-noise",
                           "the same noise, but fixed in x: asking again is of no use", add_noise,
                           Drawn::by_point);
}

Perturbation outliers() {
  return told_perturbation(
      "outliers",
      "with probability 0.2, fixed in x, a function is worse by max(1, |v|) (pi/2) "
      "times the size of a Cauchy number",
      add_outlier, Drawn::by_point);
}

namespace {

void lose(Eigen::Ref<Vector> values, Eigen::Ref<Matrix> slopes, Draws& draws) {
  constexpr double probability = 0.05;
  if (draws.uniform() >= probability) return;
  values.setConstant(std::numeric_limits<double>::quiet_NaN());
  slopes.setConstant(std::numeric_limits<double>::quiet_NaN());
}

/// Calls a function before every call of a solver; the results stay unchanged.
class Before : public PerturbedCalls {
 public:
  explicit Before(std::function<void()> before) : before_(std::move(before)) {}

  Values values(const Problem& shown, const Vector& x) override {
    before_();
    return shown.evaluate(x);
  }
  Derivatives derivatives(const Problem& shown, const Vector& x) override {
    before_();
    return shown.differentiate(x);
  }
  Residuals residuals(const Problem& shown, const Vector& x) override {
    before_();
    return shown.residuals(x);
  }
  Matrix hessian(const Problem& shown, const Vector& x, double objective_factor,
                 const Vector& multipliers) override {
    before_();
    return shown.lagrangian_hessian(x, objective_factor, multipliers);
  }

 private:
  std::function<void()> before_;
};

void compute_for_a_while() {
  constexpr double seconds = 1e-4;
  const double end = processor_seconds() + seconds;
  while (processor_seconds() < end) continue;
}

}  // namespace

Perturbation not_a_number() {
  return {"nan", "every function told is NaN with probability 0.05, independently at every call",
          [](const Problem&) { return true; },
          [](const Problem& shown, std::uint64_t seed) {
            return told_by(lose, Drawn::by_call, key_of(seed, "nan"), shown);
          }};
}

Perturbation throwing() {
  return {"throwing", "every call throws with probability 1e-3, which ends the run",
          [](const Problem&) { return true; },
          [](const Problem& shown, std::uint64_t seed) {
            constexpr double probability = 1e-3;
            const auto before = [draws = Draws(key_of(seed, "throwing"))]() mutable {
              if (draws.uniform() < probability) throw std::runtime_error("an evaluation failed");
            };
            return perturbed_by(std::make_shared<Before>(before), shown);
          }};
}

Perturbation slow() {
  return {"slow", "every call takes 0.1 ms of processor time more",
          [](const Problem&) { return true; },
          [](const Problem& shown, std::uint64_t) {
            return perturbed_by(std::make_shared<Before>(compute_for_a_while), shown);
          }};
}

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

namespace {

// The number of the residuals; objective and constraints are counted from 0.
constexpr std::uint64_t of_residuals = UINT64_MAX;
constexpr std::uint64_t of_hessian = UINT64_MAX - 1;

class Telling : public PerturbedCalls {
 public:
  Telling(Tell tell, Drawn drawn, std::uint64_t key)
      : tell_(std::move(tell)), drawn_(drawn), key_(key) {}

  Values values(const Problem& shown, const Vector& x) override {
    Values told = shown.evaluate(x);
    const std::uint64_t key = key_at(x);
    Matrix none;
    tell_values(told, key, [&none](Eigen::Index) -> Eigen::Ref<Matrix> { return none; });
    return told;
  }

  Derivatives derivatives(const Problem& shown, const Vector& x) override {
    Derivatives told = shown.differentiate(x);
    const std::uint64_t key = key_at(x);
    tell_values(told.values, key, [&told](Eigen::Index function) -> Eigen::Ref<Matrix> {
      if (function == 0) return told.gradient;
      return told.jacobian.middleRows(function - 1, 1);
    });
    return told;
  }

  Residuals residuals(const Problem& shown, const Vector& x) override {
    Residuals told = shown.residuals(x);
    Draws draws(key_of(key_at(x), of_residuals));
    tell_(told.values, told.jacobian, draws);
    return told;
  }

  Matrix hessian(const Problem& shown, const Vector& x, double objective_factor,
                 const Vector& multipliers) override {
    Matrix told = shown.lagrangian_hessian(x, objective_factor, multipliers);
    Draws draws(key_of(key_at(x), of_hessian));
    Vector none;
    tell_(none, told, draws);
    return told.selfadjointView<Eigen::Upper>();
  }

 private:
  std::uint64_t key_at(const Vector& x) {
    return drawn_ == Drawn::by_point ? key_of(key_, x) : key_of(key_, calls_++);
  }

  template <class SlopesOf>
  void tell_values(Values& told, std::uint64_t key, SlopesOf slopes_of) {
    for (Eigen::Index function = 0; function <= told.constraints.size(); ++function) {
      Draws draws(key_of(key, static_cast<std::uint64_t>(function)));
      double& value = function == 0 ? told.objective : told.constraints[function - 1];
      tell_(Eigen::Map<Vector>(&value, 1), slopes_of(function), draws);
    }
  }

  Tell tell_;
  Drawn drawn_;
  std::uint64_t key_;
  std::uint64_t calls_ = 0;
};

/// What noise makes of an optimality gap: the gap times a factor, plus an addend.
struct Noise {
  double factor = 1, addend = 0;
};
using NoiseModel = Noise (*)(double gap, double variables, Draws& draws);

Noise gaussian_noise(double, double, Draws& draws) {
  return {std::exp(draws.normal())};
}

Noise uniform_noise(double gap, double variables, Draws& draws) {
  const double least = draws.uniform();
  const double exponent = (0.49 + 1 / variables) * draws.uniform();
  return {least * std::max(1.0, std::pow(1e9 / gap, exponent))};
}

Noise cauchy_noise(double, double, Draws& draws) {
  const double outlier = draws.uniform() < 0.2 ? draws.cauchy() : 0;
  return {1, std::max(0.0, 1000 + outlier)};
}

/// Noise on the objective alone, another at every call.
class NoisyGap : public PerturbedCalls {
 public:
  NoisyGap(NoiseModel model, std::uint64_t key) : model_(model), key_(key) {}

  Values values(const Problem& shown, const Vector& x) override {
    Values told = shown.evaluate(x);
    add_noise_to(told, shown);
    return told;
  }
  Derivatives derivatives(const Problem& shown, const Vector& x) override {
    Derivatives told = shown.differentiate(x);
    told.gradient *= add_noise_to(told.values, shown);
    return told;
  }
  Residuals residuals(const Problem& shown, const Vector& x) override {
    Residuals told = shown.residuals(x);
    Values values{told.values.squaredNorm() / 2, {}};
    const double objective = values.objective;
    add_noise_to(values, shown);
    const double scale = objective > 0 ? std::sqrt(values.objective / objective) : 1;
    told.values *= scale;
    told.jacobian *= scale;
    return told;
  }
  Matrix hessian(const Problem& shown, const Vector& x, double objective_factor,
                 const Vector& multipliers) override {
    Values values = shown.evaluate(x);
    const double factor = add_noise_to(values, shown);
    return shown.lagrangian_hessian(x, objective_factor * factor, multipliers);
  }

 private:
  /// Returns the factor.
  double add_noise_to(Values& told, const Problem& shown) {
    constexpr double solved = 1e-8;
    Draws draws(key_of(key_, calls_++));
    const double gap = told.objective - shown.best_known.value();
    if (!(gap >= solved)) return 1;
    const Noise noise = model_(gap, static_cast<double>(shown.dimension()), draws);
    told.objective += (noise.factor - 1) * gap + noise.addend + 1.01 * solved;
    return noise.factor;
  }

  NoiseModel model_;
  std::uint64_t key_;
  std::uint64_t calls_ = 0;
};

Perturbation noise_of_bbob(const std::string& name, const std::string& effect, NoiseModel model) {
  return {name, "the optimality gap told is " + effect + ", another at every call",
          [](const Problem& problem) { return problem.best_known.has_value(); },
          [name, model](const Problem& shown, std::uint64_t seed) {
            return perturbed_by(std::make_shared<NoisyGap>(model, key_of(seed, name)), shown);
          }};
}

}  // namespace

Perturbation bbob_gaussian() {
  return noise_of_bbob("bbob-gaussian", "multiplied by exp of a normal number", gaussian_noise);
}

Perturbation bbob_uniform() {
  return noise_of_bbob("bbob-uniform",
                       "multiplied by two uniform powers, of which one grows near the best value",
                       uniform_noise);
}

Perturbation bbob_cauchy() {
  return noise_of_bbob("bbob-cauchy",
                       "increased by 1000, and by a Cauchy number with probability 0.2",
                       cauchy_noise);
}

Problem told_by(const Tell& tell, Drawn drawn, std::uint64_t key, const Problem& shown) {
  return perturbed_by(std::make_shared<Telling>(tell, drawn, key), shown);
}

}  // namespace ricochet
