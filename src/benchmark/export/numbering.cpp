#include "src/benchmark/export/numbering.h"

#include <fmt/format.h>

#include <string_view>

namespace ricochet::exports {
namespace {

/// A valid name made from the text that is not in `taken`; it is added there.
std::string free_name(std::string_view text, std::set<std::string>& taken) {
  constexpr std::size_t longest = 90;
  constexpr std::string_view allowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._+";
  // A file whose name begins with a dot is hidden; one with a dash looks like an option.
  std::string name(text.empty() || text[0] == '.' || text[0] == '-' ? 1 : 0, '_');
  for (const char c : text.substr(0, longest)) {
    name += allowed.find(c) == std::string_view::npos ? '_' : c;
  }
  std::string free = name;
  for (int more = 2; !taken.insert(free).second; ++more) free = fmt::format("{}_{}", name, more);
  return free;
}

}  // namespace

Numbering::Numbering(const CampaignDescription& description) {
  std::set<std::string> taken;
  for (const bool opened_by_coco : {true, false}) {
    for (const StoredProblem& problem : description.problems) {
      if ((problem.variables == 5 || problem.variables == 6) != opened_by_coco) continue;
      const int id = static_cast<int>(functions_.size()) + 1;
      functions_[problem.name] = {id, free_name(problem.name, taken)};
    }
  }
}

const std::string& Numbering::algorithm(const Cell& cell) {
  Cell algorithm = cell;
  algorithm.problem.clear();
  const auto known = algorithms_.find(algorithm);
  if (known != algorithms_.end()) return known->second;
  const std::string text = fmt::format("{}_{}_{}_price-{}_budget-{}", cell.solver, cell.formulation,
                                       cell.perturbation, cell.gradient_price, cell.budget);
  return algorithms_[algorithm] = free_name(text, taken_);
}

}  // namespace ricochet::exports
