#pragma once

#include <ctime>

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

}  // namespace ricochet::bench
