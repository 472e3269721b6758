#include "src/store/repeated_exits.h"

namespace ricochet {

std::vector<RepeatedExit> repeated(const std::vector<SolverExit>& exits) {
  std::vector<RepeatedExit> repeated;
  for (const SolverExit& exit : exits) {
    if (repeated.empty() || repeated.back().reason != exit.reason) {
      repeated.push_back({exit.reason, 0});
    }
    ++repeated.back().starts;
  }
  return repeated;
}

std::vector<SolverExit> expanded(const std::vector<RepeatedExit>& exits) {
  std::vector<SolverExit> expanded;
  for (const RepeatedExit& exit : exits) {
    expanded.resize(expanded.size() + static_cast<std::size_t>(exit.starts), {exit.reason});
  }
  return expanded;
}

}  // namespace ricochet
