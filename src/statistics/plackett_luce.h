#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "src/statistics/interval.h"
#include "src/statistics/ranking.h"

namespace ricochet {

/// What the rankings say of one solver.
struct Strength {
  double weight;                     ///< posterior mean of its chance to be first of all
  Interval weight_interval;          ///< credible, with equal tails
  double probability_of_being_best;  ///< that its weight is the largest
};

/// Plackett and Luce's model of rankings: the chance of an order is the product over places i of
/// w_i / sum_{j >= i} w_j (Plackett 1975, doi:10.2307/2346567), with all weights w alike likely at
/// first, as Calvo, Ceberio and Lozano compare algorithms (GECCO 2018 Companion). Sampled by the
/// Gibbs sampler of Caron and Doucet (2012, doi:10.1080/10618600.2012.638220). Ties are broken at
/// random, 400 times, and the answer is the mean over these orders, so that it depends on no list's
/// order and identical solvers are alike. (200 times where all rankings have a million places.) A
/// solver that did not take part in a question is judged by the others; one that failed did take
/// part, and is last. Deterministic in `seed`, whatever the threads; with another one,
/// probabilities differ by 0.01, or 0.03 where many solvers are tied. Throws std::invalid_argument
/// for rankings that name a solver twice or one that is not below `solvers`.
std::vector<Strength> plackett_luce(const std::vector<Ranking>& rankings, std::size_t solvers,
                                    std::uint64_t seed, double confidence = 0.95);

}  // namespace ricochet
