#pragma once

namespace ricochet {

/// Two-sided p-value of the hypothesis that a pair is as often won as lost: exact, from the
/// binomial distribution of the wins; draws say nothing and are left out (Arbuthnott 1710,
/// doi:10.1098/rstl.1710.0011). 1 without pairs. Throws std::invalid_argument for negative counts.
double sign_test(int wins, int losses);

}  // namespace ricochet
