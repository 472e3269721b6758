#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

#include "src/report/filled_text.h"

namespace ricochet::report {

/// A table of a template. Throws std::logic_error if a key is missing or has another type. The
/// parsed template must outlive it.
class Part {
 public:
  explicit Part(const toml::table& table) : table_(&table) {}

  bool has(std::string_view key) const { return table_->contains(key); }

  std::string text(std::string_view key) const;

  /// The text with its names filled in; "" where the key is missing.
  std::string filled_text(std::string_view key, const Scopes& scopes) const;

  /// Returns a text, or a list of texts.
  std::vector<std::string> texts(std::string_view key) const;

  /// Null if the key is missing or is not a list.
  const toml::array* list(std::string_view key) const { return (*table_)[key].as_array(); }

  /// The table of that key.
  Part part(std::string_view key) const;

  /// The tables in the list of that key; empty if it is missing.
  std::vector<Part> parts(std::string_view key) const;

  /// A number in the template, or the number of a name in the data; nothing if the key or the data
  /// are missing.
  std::optional<double> number(std::string_view key, const Scopes& scopes) const;

 private:
  const toml::table* table_;
};

/// Adds the data as the innermost scope.
Scopes with(Scopes scopes, const Json& data);

/// Returns the scopes for each repetition of a part: none unless `when` holds, one for each entry
/// of the list `each`, or else one; the data named by `data` become the innermost scope.
std::vector<Scopes> places_of(const Part& part, const Scopes& scopes);

/// Returns true if a condition of the template holds: a name whose data must be true, or with a ^
/// before it must not be.
bool holds(const std::string& condition, const Scopes& scopes);

/// A number, or the name of one in the data: "name:%" converts a share to per cent, "name:size"
/// drops the sign. Nothing if the data are null or not finite.
std::optional<double> number_in(const toml::node& value, const Scopes& scopes);

}  // namespace ricochet::report
