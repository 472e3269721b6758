#pragma once

namespace ricochet {

/// Number of successes and trials; 0 <= successes <= trials.
struct Share {
  int successes, trials;
};

/// Two-sided p-value of the hypothesis that both shares have the same probability: the probability
/// of all tables with the same margins that are not likelier than the observed one (Fisher 1934; as
/// in R and SciPy). Exact given the margins, and therefore conservative. Throws
/// std::invalid_argument for invalid counts.
double fisher_exact_test(Share a, Share b);

}  // namespace ricochet
