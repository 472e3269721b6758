#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "problems/carrier_track/suite/machine.h"
#include "ricochet/problem.h"
#include "ricochet/scene.h"

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

// The fastest speed that is quiet under uncertainty of the disturbance and of the manufacture.

/// The number of sampled scenes.
inline constexpr std::size_t robust_samples = 32;

/// Samples of the uncertain scene: the phase of the disturbance uniform, its amplitude within 20 %
/// and 0.05 N higher, so that every scene has one; the clearance within 5 %; the mass, with the m
/// r_c that contains it, within 2 %; the friction within 10 %; the restitution within 5 %, but in
/// [0, 1]. The draws are the first 32 points of a Sobol sequence, more even than random points,
/// shifted by one random vector (Cranley and Patterson, SIAM J. Numer. Anal. 13 (1976) 904): the
/// same for every machine, speed and risk.
std::vector<Scene> sampled_scenes(const Scene& scene);

/// Minimise -speed subject to risk of the counts of the sampled scenes <= quiet limit, without
/// derivatives. The surrogates have them.
Problem robust_problem(const Machine& machine, RiskMeasure risk);

}  // namespace ricochet::carrier_track::inline problems
