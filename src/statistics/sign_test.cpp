#include "src/statistics/sign_test.h"

#include <algorithm>
#include <boost/math/distributions/binomial.hpp>
#include <stdexcept>

namespace ricochet {

double sign_test(int wins, int losses) {
  if (wins < 0 || losses < 0) throw std::invalid_argument("sign_test: a count is negative");
  if (wins == losses) return 1;
  const boost::math::binomial won(wins + losses, 0.5);
  return std::min(1.0, 2 * cdf(won, std::min(wins, losses)));
}

}  // namespace ricochet
