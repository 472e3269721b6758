#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ricochet/error.h"
#include "src/core/near_names.h"
#include "src/core/option_value.h"
#include "src/core/toml_text.h"

namespace ricochet {

/// A node as TOML text.
inline std::string text_of_node(const toml::node& node) {
  std::ostringstream text;
  node.visit([&](const auto& value) { text << value; });
  return text.str();
}

/// A table of a plan and its place in it.
class PlanTable {
 public:
  PlanTable(const toml::table& table, std::string place)
      : table_(table), place_(std::move(place)) {}

  /// Throws InputError for unknown keys.
  void check_keys(const std::vector<std::string>& known) const {
    for (const auto& [key, node] : table_) {
      const std::string name(key.str());
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      throw InputError(
          fmt::format("{}: there is no key {}; {}", place_, name, what_instead(name, known)));
    }
  }

  void need(std::string_view key) const {
    if (!table_.contains(key)) throw InputError(fmt::format("{}: {} is missing", place_, key));
  }

  void read(std::string_view key, std::string& target) const {
    const toml::node* node = table_.get(key);
    if (node == nullptr) return;
    if (!node->is_string()) refuse(key, *node, "a text");
    target = node->as_string()->get();
  }

  void read(std::string_view key, double& target) const {
    const toml::node* node = table_.get(key);
    if (node != nullptr) target = finite(key, *node);
  }

  /// Any finite number, or a non-empty text; required.
  void read(std::string_view key, OptionValue& target) const {
    target = number_or_text(key, *table_.get(key));
  }

  /// One of them or a list.
  void read(std::string_view key, std::vector<OptionValue>& target) const {
    read_list(key, target, [&](const toml::node& node) { return number_or_text(key, node); });
  }

  void read(std::string_view key, std::optional<bool>& target) const {
    const toml::node* node = table_.get(key);
    if (node == nullptr) return;
    if (!node->is_boolean()) refuse(key, *node, "true or false");
    target = node->as_boolean()->get();
  }

  void read(std::string_view key, bool& target) const {
    std::optional<bool> value;
    read(key, value);
    target = value.value_or(target);
  }

  void read(std::string_view key, int& target) const {
    const toml::node* node = table_.get(key);
    if (node != nullptr) target = static_cast<int>(whole(key, *node, 1, 1'000'000));
  }

  /// One text or a list of texts.
  void read(std::string_view key, std::vector<std::string>& target) const {
    read_list(key, target, [&](const toml::node& node) {
      if (!node.is_string() || node.as_string()->get().empty()) refuse(key, node, "texts");
      return node.as_string()->get();
    });
  }

  /// Texts, and whole numbers converted to text.
  void read_prices(std::string_view key, std::vector<std::string>& target) const {
    read_list(key, target, [&](const toml::node& node) -> std::string {
      if (node.is_integer()) return std::to_string(whole(key, node, 0, 1'000'000'000));
      if (node.is_string()) {
        const std::string& price = node.as_string()->get();
        if (price == "n" || price == "measured") return price;
      }
      refuse(key, node, "\"n\", \"measured\" or a whole number >= 0");
    });
  }

  void read(std::string_view key, std::vector<double>& target, bool may_be_zero) const {
    read_list(key, target, [&](const toml::node& node) { return finite(key, node, may_be_zero); });
  }

  void read(std::string_view key, std::vector<std::int64_t>& target) const {
    read_list(key, target,
              [&](const toml::node& node) { return whole(key, node, 1, 1'000'000'000'000); });
    if (!std::is_sorted(target.begin(), target.end(), std::less_equal<>())) {
      throw InputError(
          fmt::format("{}: {} = [{}]: must rise", place_, key, fmt::join(target, ", ")));
    }
  }

  [[noreturn]] void refuse(std::string_view key, const toml::node& node,
                           std::string_view allowed) const {
    throw InputError(
        fmt::format("{}: {} = {}: must be {}", place_, key, text_of_node(node), allowed));
  }

 private:
  double finite(std::string_view key, const toml::node& node, bool may_be_zero = false) const {
    const auto number = node.is_number() ? node.value<double>() : std::nullopt;
    if (!number || !std::isfinite(*number) || *number < 0 || (*number == 0 && !may_be_zero)) {
      refuse(key, node, may_be_zero ? "finite numbers >= 0" : "finite numbers > 0");
    }
    return *number + 0.0;  // no -0
  }

  OptionValue number_or_text(std::string_view key, const toml::node& node) const {
    const auto number = node.is_number() ? node.value<double>() : std::nullopt;
    if (number && std::isfinite(*number)) return *number + 0.0;  // no -0
    if (node.is_string() && !node.as_string()->get().empty()) return node.as_string()->get();
    refuse(key, node, "a finite number or a text");
  }

  std::int64_t whole(std::string_view key, const toml::node& node, std::int64_t least,
                     std::int64_t most) const {
    const auto number = node.is_integer() ? node.value<std::int64_t>() : std::nullopt;
    if (!number || *number < least || *number > most) {
      refuse(key, node, fmt::format("a whole number from {} to {}", least, most));
    }
    return *number;
  }

  template <class Entry, class Read>
  void read_list(std::string_view key, std::vector<Entry>& target, Read read) const {
    const toml::node* node = table_.get(key);
    if (node == nullptr) return;
    target.clear();
    if (const toml::array* list = node->as_array()) {
      for (const toml::node& entry : *list) target.push_back(read(entry));
      auto sorted = target;
      std::sort(sorted.begin(), sorted.end());
      if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) {
        refuse(key, *node, "a list without repetitions");
      }
    } else {
      target.push_back(read(*node));
    }
  }

  const toml::table& table_;
  std::string place_;
};

}  // namespace ricochet
