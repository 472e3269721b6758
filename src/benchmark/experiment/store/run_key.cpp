#include "src/benchmark/experiment/store/run_key.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "src/core/number_of_text.h"

namespace ricochet {
namespace {

/// Reads a whole number >= 0; false if the text is anything else.
template <class Number>
bool read_count(std::string_view text, Number& count) {
  const auto number = number_of_text<Number>(text);
  if (number && *number >= 0) count = *number;
  return number && *number >= 0;
}

}  // namespace

std::string name_of(const RunKey& key) {
  const Cell& cell = key.cell;
  return fmt::format(
      "run {} of {} on instance {} of {} (formulation {}, perturbation {}, budget {}, gradient "
      "price {})",
      key.run, cell.solver, key.instance, cell.problem, cell.formulation, cell.perturbation,
      cell.budget, cell.gradient_price);
}

std::string address_of(const RunKey& key) {
  const Cell& cell = key.cell;
  return fmt::format("{}/{}/{}/{}/{}/{}/{}/{}", cell.problem, cell.formulation, cell.perturbation,
                     cell.solver, cell.budget, cell.gradient_price, key.instance, key.run);
}

std::optional<RunKey> key_at(const std::string& address) {
  std::vector<std::string> parts(1);
  for (const char c : address) {
    if (c == '/') {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  constexpr std::size_t members = 8;
  RunKey key;
  if (parts.size() != members || !read_count(parts[4], key.cell.budget) ||
      !read_count(parts[6], key.instance) || !read_count(parts[7], key.run)) {
    return std::nullopt;
  }
  key.cell.problem = parts[0];
  key.cell.formulation = parts[1];
  key.cell.perturbation = parts[2];
  key.cell.solver = parts[3];
  key.cell.gradient_price = parts[5];
  return key;
}

}  // namespace ricochet
