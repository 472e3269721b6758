#pragma once

#include <fmt/format.h>
#include <toml++/toml.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "problems/carrier_track/scene/scene_fields.h"
#include "problems/carrier_track/scene/scene_file.h"

namespace ricochet::carrier_track::inline scene {

/// The uncertain numbers of a file, in the order in which they are read.
struct Uncertain {
  std::span<const double> shares = {};  ///< where each is read, see SceneFile; empty: at its value
  std::vector<Uncertainty> found = {};  ///< those read so far
};

/// One table of a TOML file. A number may be a text with a unit, see toml_table.h, and either may
/// be a table {value = ..., plus_minus = ...}. An invalid entry throws InputError with origin (the
/// file), table, key, value and the allowed values.
class TomlTable {
 public:
  /// Uncertain numbers are read and recorded as `uncertain` says; it must outlive the table.
  TomlTable(const toml::table& file, std::string name, std::string origin, Uncertain& uncertain);

  const std::string& name() const { return name_; }
  bool exists() const { return table_.has_value(); }
  bool has(std::string_view key) const { return table_ && table_->contains(key); }

  /// Throws InputError for a key that is not one of these.
  void refuse_others_than(const std::vector<std::string>& known) const;

  /// Reads `old_key`, as version 1 had it, in the place of `key`, with a warning.
  void renamed(std::string_view old_key, std::string_view key);
  void need(std::string_view key) const;

  void number(const Field& field, double& target);
  void boolean(std::string_view key, bool& target) const;

  /// One number for both walls under the key, or one for each under key_lower and key_upper;
  /// required. An array of two under the key, as version 1 had it, is read with a warning.
  void walls(const Field& field, double& lower, double& upper);

  /// A number, or the word `none`, which leaves it without value.
  void number_or(const Field& field, std::string_view none, std::optional<double>& target);

  /// A number, or an array of [time, omega].
  void number_or_knots(const Field& field, double& target, std::vector<SpeedKnot<double>>& knots);

  template <class Value>
  void choice(std::string_view key, const EnumNames<Value>& choices, Value& target) const {
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

 private:
  double number_of(const Field& field, const toml::node& node, std::string_view others = "");
  double certain_number_of(const Field& field, const toml::node& node,
                           std::string_view others) const;
  [[noreturn]] void refuse(std::string_view key, const toml::node& node,
                           std::string_view allowed) const;

  std::string name_;
  std::string origin_;
  Uncertain& uncertain_;
  std::optional<toml::table> table_;
};

/// The units in which a text may give a number whose SI unit is `unit`: "m", "cm", "mm" for "m".
/// Empty for a number without a unit, and for units that depend on other numbers.
std::vector<std::string_view> units_for(std::string_view unit);

/// The number [unit] that a text gives: a number and one of units_for(unit), with or without a
/// blank between. "0.8 mm" is
/// 0.0008 for "m". Returns nothing for any other text.
std::optional<double> quantity(std::string_view text, std::string_view unit);

}  // namespace ricochet::carrier_track::inline scene
