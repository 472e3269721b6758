#include "src/benchmark/statistics/fisher_exact_test.h"

#include <algorithm>
#include <boost/math/distributions/hypergeometric.hpp>
#include <stdexcept>

namespace ricochet {

double fisher_exact_test(Share a, Share b) {
  for (const Share& share : {a, b}) {
    if (share.successes < 0 || share.successes > share.trials) {
      throw std::invalid_argument("fisher_exact_test: 0 <= successes <= trials is needed");
    }
  }
  const int successes = a.successes + b.successes;
  const int trials = a.trials + b.trials;
  const int first = std::max(0, successes - b.trials);
  const int last = std::min(successes, a.trials);
  if (first == last) return 1;  // this is the only table with these margins
  const boost::math::hypergeometric drawn(static_cast<unsigned>(successes),
                                          static_cast<unsigned>(a.trials),
                                          static_cast<unsigned>(trials));
  // Tables of equal probability count as equally rare despite rounding.
  const double seen = pdf(drawn, a.successes) * (1 + 1e-7);
  double p_value = 0;
  for (int k = first; k <= last; ++k) {
    const double probability = pdf(drawn, k);
    if (probability <= seen) p_value += probability;
  }
  return std::min(1.0, p_value);
}

}  // namespace ricochet
