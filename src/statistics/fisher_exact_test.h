#pragma once

namespace ricochet {

/// Successes of trials; 0 <= successes <= trials.
struct Share {
  int successes, trials;
};

/// Two-sided p-value of the hypothesis that both shares are of one probability: that of all tables
/// with the same margins that are not likelier than the one seen (Fisher 1934; as in R and SciPy).
/// Exact for the margins, and so rather too large than too small. Throws std::invalid_argument for
/// counts that do not fit.
double fisher_exact_test(Share a, Share b);

}  // namespace ricochet
