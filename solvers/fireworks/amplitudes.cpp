#include "solvers/fireworks/amplitudes.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ricochet::fireworks {

Vector explosion_amplitudes(const Vector& fitness, double amplitude, double epsilon) {
  const Vector excess = fitness.array() - fitness.minCoeff();
  return amplitude * (excess.array() + epsilon) / (excess.sum() + epsilon);
}

double AmplitudeFloor::after(double evaluations, double budget) const {
  if (!(budget > 0)) return first;
  const double t = std::clamp(evaluations / budget, 0.0, 1.0);
  return first - (first - last) * std::sqrt((2 - t) * t);
}

void check(const AmplitudeSteps& steps) {
  if (!(steps.growth >= 1 && steps.decline > 0 && steps.decline <= 1)) {
    throw std::invalid_argument("amplitude steps: need growth >= 1 and 0 < decline <= 1");
  }
}

}  // namespace ricochet::fireworks
