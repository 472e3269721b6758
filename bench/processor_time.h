#pragma once

#include <algorithm>
#include <ctime>
#include <limits>
#include <utility>

namespace ricochet::bench {

/// Processor time [s] of one call of `work`, the mean over at least so long [s].
template <class Work>
double processor_time(const Work& work, double at_least) {
  int calls = 0;
  const std::clock_t start = std::clock();
  double passed = 0;
  do {
    work();
    ++calls;
    passed = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  } while (passed < at_least);
  return passed / calls;
}

/// The fastest processor time [s] of either, of so many rounds of at least so long [s], by turns,
/// as other work on the machine slows now this and now that.
template <class One, class Other>
std::pair<double, double> fastest_of(const One& one, const Other& other, int rounds,
                                     double at_least) {
  double of_one = std::numeric_limits<double>::infinity();
  double of_other = of_one;
  for (int i = 0; i < rounds; ++i) {
    of_one = std::min(of_one, processor_time(one, at_least));
    of_other = std::min(of_other, processor_time(other, at_least));
  }
  return {of_one, of_other};
}

}  // namespace ricochet::bench
