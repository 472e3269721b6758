#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

#include "src/report/filled_text.h"

namespace ricochet::report {

/// A table of a template; its keys are asked for by name. Throws std::logic_error where a key is
/// missing or of another kind. The parsed template must outlive it.
class Part {
 public:
  explicit Part(const toml::table& table) : table_(&table) {}

  bool has(std::string_view key) const { return table_->contains(key); }

  std::string text(std::string_view key) const;

  /// The text with its names filled in; "" where the key is missing.
  std::string filled_text(std::string_view key, const Scopes& scopes) const;

  /// A text, or the list of texts that stands in its place.
  std::vector<std::string> texts(std::string_view key) const;

  /// None where the key is missing, or no list.
  const toml::array* list(std::string_view key) const { return (*table_)[key].as_array(); }

  /// The table of that key.
  Part part(std::string_view key) const;

  /// The tables in the list of that key; none where it is missing.
  std::vector<Part> parts(std::string_view key) const;

  /// A number of the template, or that of a name in the data; nothing where the key is missing or
  /// the data have none.
  std::optional<double> number(std::string_view key, const Scopes& scopes) const;

 private:
  const toml::table* table_;
};

/// The scopes, and inside of them the data.
Scopes with(Scopes scopes, const Json& data);

/// The scopes in which a part stands: none unless `when` holds, else one, or one for each entry of
/// the list `each`; inside of them is what `data` names.
std::vector<Scopes> places_of(const Part& part, const Scopes& scopes);

/// Whether a condition of the template holds: the name of what must be a yes, or after a ^ of what
/// must not.
bool holds(const std::string& condition, const Scopes& scopes);

/// A number, or the name of one in the data: "name:%" takes a share as hundredths, "name:size"
/// drops the sign. Nothing where the data have null, or a number that is not finite.
std::optional<double> number_in(const toml::node& value, const Scopes& scopes);

}  // namespace ricochet::report
