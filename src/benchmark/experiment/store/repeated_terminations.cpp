#include "src/benchmark/experiment/store/repeated_terminations.h"

namespace ricochet {

std::vector<RepeatedTermination> repeated(const std::vector<SolverTermination>& terminations) {
  std::vector<RepeatedTermination> repeated;
  for (const SolverTermination& exit : terminations) {
    if (repeated.empty() || repeated.back().reason != exit.reason) {
      repeated.push_back({exit.reason, 0});
    }
    ++repeated.back().starts;
  }
  return repeated;
}

std::vector<SolverTermination> expanded(const std::vector<RepeatedTermination>& terminations) {
  std::vector<SolverTermination> expanded;
  for (const RepeatedTermination& exit : terminations) {
    expanded.resize(expanded.size() + static_cast<std::size_t>(exit.starts), {exit.reason});
  }
  return expanded;
}

}  // namespace ricochet
