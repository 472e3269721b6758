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

/// One table of a TOML file. Every key that a member function reads is known; finish() rejects all
/// others. Keys may be made known before, so that an unknown one is told before a missing one. An
/// invalid entry throws InputError with origin (the file), table, key, value and the allowed
/// values.
class TomlTable {
 public:
  TomlTable(const toml::table& file, std::string name, std::string origin);

  bool exists() const { return table_.has_value(); }
  bool has(std::string_view key);

  /// Makes a key known without reading it.
  void know(std::string_view key) { known_.emplace(key); }

  /// The same with those that walls() reads.
  void know_walls(std::string_view key);

  /// Reads `old_key`, as version 1 had it, in the place of `key`, with a warning.
  void renamed(std::string_view old_key, std::string_view key);
  void need(std::string_view key);

  void number(std::string_view key, double& target);
  void boolean(std::string_view key, bool& target);

  /// One number for both walls under `key`, or one for each under key_lower and key_upper;
  /// required. An array of two under `key`, as version 1 had it, is read with a warning.
  void walls(std::string_view key, double& lower, double& upper);

  /// A number, or the word `none`, which leaves it without value.
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
  std::optional<toml::table> table_;
  std::set<std::string> known_;
};

}  // namespace ricochet::carrier_track::inline scene
