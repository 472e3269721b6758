#pragma once

#include <vector>

#include "problems/carrier_track/questions/machine.h"
#include "problems/carrier_track/questions/risk_measure.h"
#include "src/core/question.h"

/// The fastest speed that is quiet in spite of what nobody knows: the disturbance, and how the
/// machine was made.
namespace ricochet::carrier_track::inline questions {

/// How many scenes stand for all there may be.
inline constexpr std::size_t robust_samples = 32;

/// The scene as it may turn out: the phase of the disturbance uniform, its amplitude within 20 %
/// and 0.05 N higher, so that every scene has one; the clearance within 5 %, the mass, with the
/// m r_c that it is a part of, within 2 %, the friction within 10 %, the restitution within 5 %,
/// but in [0, 1]. The draws are the first 32 points of a Sobol sequence, which fill the cube more
/// evenly than chance, shifted by one random vector (Cranley and Patterson, SIAM J. Numer. Anal. 13
/// (1976) 904): the same for every machine, speed and risk.
std::vector<Scene> sampled_scenes(const Scene& scene);

/// Minimise -speed subject to risk of the counts of the sampled scenes <= quiet limit, without
/// derivatives. The surrogates have them.
Question robust_question(const Machine& machine, RiskMeasure risk);

}  // namespace ricochet::carrier_track::inline questions
