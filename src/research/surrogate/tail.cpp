#include "src/research/surrogate/tail.h"

#include <algorithm>
#include <cmath>

namespace ricochet::studies::surrogate {

report::Json tail_of(const std::vector<double>& rising) {
  report::Json tail = report::Json::array();
  for (int k = 0; k <= 64; ++k) {
    const double limit = 1e-16 * std::pow(10.0, 0.25 * k);
    const std::size_t larger = larger_than(limit, rising);
    if (larger == 0) break;
    tail.push_back({{"limit", limit},
                    {"share", static_cast<double>(larger) / static_cast<double>(rising.size())}});
  }
  return tail;
}

std::size_t larger_than(double limit, const std::vector<double>& rising) {
  return static_cast<std::size_t>(rising.end() -
                                  std::upper_bound(rising.begin(), rising.end(), limit));
}

}  // namespace ricochet::studies::surrogate
