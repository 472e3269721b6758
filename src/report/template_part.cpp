#include "src/report/template_part.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace ricochet::report {

std::string Part::text(std::string_view key) const {
  const auto value = (*table_)[key].value<std::string>();
  if (!value) throw std::logic_error(fmt::format("a template's {} must be a text", key));
  return *value;
}

std::string Part::filled_text(std::string_view key, const Scopes& scopes) const {
  return has(key) ? filled(text(key), scopes) : "";
}

std::vector<std::string> Part::texts(std::string_view key) const {
  const toml::array* array = list(key);
  if (array == nullptr) return {text(key)};
  std::vector<std::string> all;
  for (const toml::node& node : *array) all.push_back(node.value<std::string>().value());
  return all;
}

Part Part::part(std::string_view key) const {
  const toml::table* table = (*table_)[key].as_table();
  if (table == nullptr) throw std::logic_error(fmt::format("a template's {} must be a table", key));
  return Part(*table);
}

std::vector<Part> Part::parts(std::string_view key) const {
  std::vector<Part> all;
  if (const toml::array* array = list(key)) {
    for (const toml::node& node : *array) all.emplace_back(*node.as_table());
  }
  return all;
}

std::optional<double> Part::number(std::string_view key, const Scopes& scopes) const {
  const toml::node* node = table_->get(key);
  return node == nullptr ? std::nullopt : number_in(*node, scopes);
}

Scopes with(Scopes scopes, const Json& data) {
  scopes.push_back(&data);
  return scopes;
}

std::vector<Scopes> places_of(const Part& part, const Scopes& scopes) {
  std::vector<Scopes> places;
  if (part.has("when") && !holds(part.text("when"), scopes)) return places;
  if (part.has("each")) {
    for (const Json& entry : found_in(scopes, part.text("each"))) {
      places.push_back(with(scopes, entry));
    }
  } else {
    places.push_back(scopes);
  }
  if (part.has("data")) {
    for (Scopes& place : places) place.push_back(&found_in(place, part.filled_text("data", place)));
  }
  return places;
}

bool holds(const std::string& condition, const Scopes& scopes) {
  const bool negated = condition.starts_with('^');
  return is_yes(found_in(scopes, condition.substr(negated ? 1 : 0))) != negated;
}

std::optional<double> number_in(const toml::node& value, const Scopes& scopes) {
  if (const auto number = value.value<double>()) return number;
  const auto asked = value.value<std::string>();
  if (!asked) throw std::logic_error("a template's value must be a number or a name");
  const std::size_t colon = asked->find(':');
  const Json& data = found_in(scopes, asked->substr(0, colon));
  if (!data.is_number() && !data.is_null()) {
    throw std::logic_error(fmt::format("a template's {} is no number", *asked));
  }
  if (data.is_null() || !std::isfinite(data.get<double>())) return std::nullopt;
  const double number = data.get<double>();
  const std::string formulation = colon == std::string::npos ? "" : asked->substr(colon + 1);
  if (formulation.empty()) return number;
  if (formulation == "%") return 100 * number;
  if (formulation == "size") return std::abs(number);
  throw std::logic_error(fmt::format("a template's {}: must end in :% or :size", *asked));
}

}  // namespace ricochet::report
