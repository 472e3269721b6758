#include "src/experiment/perturbations.h"

#include <bit>
#include <cmath>
#include <numbers>

namespace ricochet {

namespace {

Perturbation plain() {
  return {"plain", "as it is", [](const Problem&) { return true; },
          [](const Problem& shown, std::uint64_t) { return shown; }};
}

}  // namespace

const std::vector<Perturbation>& all_perturbations() {
  static const std::vector<Perturbation> perturbations = {plain(),
                                                          perturbed_start(),
                                                          noisy(),
                                                          frozen_noise(),
                                                          outliers(),
                                                          bbob_gaussian(),
                                                          bbob_uniform(),
                                                          bbob_cauchy(),
                                                          truncated(),
                                                          not_a_number(),
                                                          infinite_where_infeasible(),
                                                          binary_constraints(),
                                                          quantised(),
                                                          permuted(),
                                                          reflected(),
                                                          rotated(),
                                                          throwing(),
                                                          slow()};
  return perturbations;
}

std::string shown_as(const std::string& formulation, const std::string& perturbation) {
  return perturbation == "plain" ? formulation : formulation + "/" + perturbation;
}

namespace {

/// The problem with true values of its own, taken from the values it shows. It remembers the last
/// point, because the evaluator scores the point that the solver has just evaluated.
Problem with_true_values(const Problem& problem) {
  if (problem.true_values) return problem;
  struct Seen {
    Vector x;
    TrueValues true_values;
  };
  const auto seen = std::make_shared<Seen>();
  const Eigen::Index equalities = problem.equalities;
  const auto remember = [seen, equalities](const Vector& x, const Values& values) {
    seen->x = x;
    seen->true_values = true_values_of(values, equalities);
  };
  Problem result = problem;
  result.evaluate = [evaluate = problem.evaluate, remember](const Vector& x) {
    Values values = evaluate(x);
    remember(x, values);
    return values;
  };
  if (problem.differentiate) {
    result.differentiate = [differentiate = problem.differentiate, remember](const Vector& x) {
      Derivatives derivatives = differentiate(x);
      remember(x, derivatives.values);
      return derivatives;
    };
  }
  result.true_values = [evaluate = problem.evaluate, seen, equalities](const Vector& x) {
    const bool known = seen->x.size() == x.size() && seen->x == x;
    return known ? seen->true_values : true_values_of(evaluate(x), equalities);
  };
  return result;
}

}  // namespace

Values PerturbedCalls::values(const Problem& shown, const Vector& x) {
  return shown.evaluate(x);
}

Derivatives PerturbedCalls::derivatives(const Problem& shown, const Vector& x) {
  return shown.differentiate(x);
}

Residuals PerturbedCalls::residuals(const Problem& shown, const Vector& x) {
  return shown.residuals(x);
}

Matrix PerturbedCalls::hessian(const Problem& shown, const Vector& x, double objective_factor,
                               const Vector& multipliers) {
  return shown.lagrangian_hessian(x, objective_factor, multipliers);
}

TrueValues PerturbedCalls::true_values(const Problem& shown, const Vector& x) {
  return shown.true_values(x);
}

Problem perturbed_by(const std::shared_ptr<PerturbedCalls>& perturbation, const Problem& shown) {
  const auto original = std::make_shared<const Problem>(with_true_values(shown));
  Problem result = shown;
  result.evaluate = [original, perturbation](const Vector& x) {
    return perturbation->values(*original, x);
  };
  if (shown.differentiate) {
    result.differentiate = [original, perturbation](const Vector& x) {
      return perturbation->derivatives(*original, x);
    };
  }
  if (shown.residuals) {
    result.residuals = [original, perturbation](const Vector& x) {
      return perturbation->residuals(*original, x);
    };
  }
  result.residual_values = nullptr;
  if (shown.lagrangian_hessian) {
    result.lagrangian_hessian = [original, perturbation](const Vector& x, double objective_factor,
                                                         const Vector& multipliers) {
      return perturbation->hessian(*original, x, objective_factor, multipliers);
    };
  }
  result.true_values = [original, perturbation](const Vector& x) {
    return perturbation->true_values(*original, x);
  };
  if (shown.smoothed) {
    result.smoothed = [smoothed = shown.smoothed, perturbation](double width) {
      return perturbed_by(perturbation, smoothed(width));
    };
  }
  return result;
}

namespace {

constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;  // 2^64 divided by the golden ratio, odd

std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111eb;
  return bits ^ (bits >> 31);
}

}  // namespace

std::uint64_t key_of(std::uint64_t key, std::uint64_t number) {
  // NOTE: without the sum, key 0 and number 0 would give 0 again.
  return mixed((key ^ number) + golden);
}

std::uint64_t key_of(std::uint64_t key, std::string_view name) {
  for (const char c : name) key = key_of(key, static_cast<unsigned char>(c));
  return key;
}

std::uint64_t key_of(std::uint64_t key, const Vector& point) {
  for (const double x : point) key = key_of(key, std::bit_cast<std::uint64_t>(x + 0.0));
  return key;
}

std::uint64_t Draws::bits() {
  state_ += golden;
  return mixed(state_);
}

double Draws::uniform() {
  return static_cast<double>(bits() >> 11) * 0x1p-53;
}

double Draws::normal() {
  const double length = std::sqrt(-2 * std::log(1 - uniform()));
  return length * std::cos(2 * std::numbers::pi * uniform());
}

double Draws::cauchy() {
  return std::tan(std::numbers::pi * (uniform() - 0.5));
}

namespace {

Vector moved_start(const Problem& problem, std::uint64_t seed) {
  constexpr double length = 1e-3;
  Draws draws(key_of(seed, "perturbed-start"));
  Vector direction(problem.dimension());
  for (double& coordinate : direction) coordinate = draws.normal();
  direction.normalize();
  Vector start = problem.start;
  for (Eigen::Index i = 0; i < start.size(); ++i) {
    const double step = length * direction[i] * (problem.upper[i] - problem.lower[i]);
    const double there = start[i] + step;
    const bool inside = there >= problem.lower[i] && there <= problem.upper[i];
    start[i] = inside ? there : start[i] - step;
  }
  return start;
}

Problem with_start(const Problem& problem, const Vector& start) {
  Problem result = problem;
  result.start = start;
  if (result.start_scales.empty()) result.start_scales = {1.0};
  if (problem.smoothed) {
    result.smoothed = [smoothed = problem.smoothed, start](double width) {
      return with_start(smoothed(width), start);
    };
  }
  return result;
}

}  // namespace

Perturbation perturbed_start() {
  return {"perturbed-start", "the start is moved by 1e-3 of the box in a random direction",
          [](const Problem&) { return true; },
          [](const Problem& shown, std::uint64_t seed) {
            return with_start(shown, moved_start(shown, seed));
          }};
}

}  // namespace ricochet
