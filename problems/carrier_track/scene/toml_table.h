#pragma once

#include <fmt/format.h>
#include <toml++/toml.h>

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "problems/carrier_track/scene/enum_names.h"

namespace ricochet::carrier_track::inline scene {

/// One table of a TOML file. Every key asked for is known; finish() refuses the others. What is not
/// as it must be throws InputError, with origin (the file), table, key, value and what is allowed.
class TomlTable {
 public:
  TomlTable(const toml::table& file, std::string name, std::string origin);

  bool exists() const { return table_ != nullptr; }
  bool has(std::string_view key);
  void need(std::string_view key);

  void number(std::string_view key, double& target);
  void boolean(std::string_view key, bool& target);

  /// One number for both, or an array of two; must be there.
  void pair(std::string_view key, double& first, double& second);

  /// A number, or a word that stands for none.
  void number_or(std::string_view key, std::string_view none, std::optional<double>& target);

  /// A number, or an array of [time, omega].
  void number_or_knots(std::string_view key, double& target, std::vector<SpeedKnot<double>>& knots);

  template <class Value>
  void choice(std::string_view key, const EnumNames<Value>& choices, Value& target) {
    if (!has(key)) return;
    const toml::node& node = *table_->get(key);
    std::string allowed;
    for (const auto& [name, value] : choices) {
      if (node.is_string() && node.as_string()->get() == name) {
        target = value;
        return;
      }
      allowed += fmt::format("{}\"{}\"", allowed.empty() ? "" : " or ", name);
    }
    refuse(key, node, allowed);
  }

  void finish() const;

 private:
  double number_of(std::string_view key, const toml::node& node, std::string_view allowed) const;
  [[noreturn]] void refuse(std::string_view key, const toml::node& node,
                           std::string_view allowed) const;

  std::string name_;
  std::string origin_;
  const toml::table* table_;
  std::set<std::string> known_;
};

}  // namespace ricochet::carrier_track::inline scene
