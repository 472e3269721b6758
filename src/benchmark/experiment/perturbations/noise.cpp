#include "src/benchmark/experiment/perturbations/noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "src/benchmark/experiment/perturbations/telling.h"

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
      "every number v told is v + 1e-3 max(1, |v|) times a normal one, drawn anew "
      "at every call",
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

}  // namespace ricochet
