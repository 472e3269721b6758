#pragma once

#include <vector>

#include "problems/carrier_track/problems/machine.h"
#include "problems/carrier_track/problems/risk_measure.h"
#include "ricochet/problem.h"

/// The fastest speed that is quiet under uncertainty of the disturbance and of the manufacture.
namespace ricochet::carrier_track::inline problems {

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
