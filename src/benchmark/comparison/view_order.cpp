#include "src/benchmark/comparison/view_order.h"

#include <algorithm>

#include "src/benchmark/comparison/view_run.h"

namespace ricochet::studies::comparison {

void ViewOrderWriter::add(const RankedTogether& together, const Reached& reached) {
  std::vector<Value>& values = values_[together];
  const Value value{reached.value, reached.cost};
  const auto place = std::ranges::lower_bound(values, value);
  const bool known = place != values.end() && *place == value;
  const auto position = 2 * static_cast<std::size_t>(place - values.begin()) + (known ? 1 : 0);
  for (std::size_t weight = 1; weight <= 2 * values.size(); weight *= 2) {
    bits_.push_back((position & weight) != 0);
  }
  if (!known) values.insert(place, value);
}

std::string ViewOrderWriter::text() const {
  std::string text;
  for (std::size_t from = 0; from < bits_.size(); from += 6) {
    std::int64_t digit = 0;
    for (std::size_t bit = from; bit < std::min(from + 6, bits_.size()); ++bit) {
      if (bits_[bit]) digit += std::int64_t{1} << (bit - from);
    }
    text += view_digit(digit);
  }
  return text;
}

}  // namespace ricochet::studies::comparison
