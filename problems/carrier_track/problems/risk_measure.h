#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "ricochet/scalar.h"

namespace ricochet::carrier_track::inline problems {

/// A risk measure: it reduces the losses of many samples to one number.
enum class RiskMeasure { mean, worst, cvar };

/// The share of samples that CVaR averages: the worst tenth.
inline constexpr double tail_share = 0.1;

/// "mean", "worst" or "cvar".
inline std::string_view name_of(RiskMeasure risk) {
  constexpr std::array<std::string_view, 3> names = {"mean", "worst", "cvar"};
  return names[static_cast<std::size_t>(risk)];
}

/// The weights of the losses, from the worst one on; they sum to 1, for 32 losses without rounding.
inline std::vector<double> risk_weights(RiskMeasure risk, std::size_t size) {
  const auto n = static_cast<double>(size);
  const double whole = risk == RiskMeasure::mean    ? 1 / n
                       : risk == RiskMeasure::worst ? 1
                                                    : 1 / (tail_share * n);
  std::vector<double> weights(size, 0.0);
  double left = 1;
  for (std::size_t k = 0; k < size && left > 0; ++k) {
    weights[k] = std::min(whole, left);
    left -= weights[k];
  }
  return weights;
}

/// The mean, the worst, or the mean of the worst tenth of at least one loss; if a tenth is not a
/// whole number of samples, the last one counts in part. The latter is the conditional value at
/// risk, min over t of t + mean(max(0, loss - t)) / tail_share (Rockafellar and Uryasev, J. Risk 2
/// (2000) 21-41, doi 10.21314/JOR.2000.038). All three are convex and monotone; cvar lies between
/// the others. Derivatives are one-sided at equal losses.
template <class Scalar>
Scalar risk_of(RiskMeasure risk, std::vector<Scalar> losses) {
  std::stable_sort(losses.begin(), losses.end(),
                   [](const Scalar& a, const Scalar& b) { return value(a) > value(b); });
  const std::vector<double> weights = risk_weights(risk, losses.size());
  Scalar sum = constant<Scalar>(0.0);
  for (std::size_t k = 0; k < losses.size(); ++k) {
    if (weights[k] > 0) sum += constant<Scalar>(weights[k]) * losses[k];
  }
  return sum;
}

}  // namespace ricochet::carrier_track::inline problems
