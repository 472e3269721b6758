#pragma once

#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "src/core/fields.h"

namespace ricochet::report {

/// What a report is drawn from: the results of a study, in the order in which they were computed.
/// Numbers keep all their digits; what is missing is null.
using Json = nlohmann::ordered_json;

/// A list of what is made of each entry.
template <class List, class Make>
Json list_of(const List& list, const Make& make) {
  Json all = Json::array();
  for (const auto& entry : list) all.push_back(std::invoke(make, entry));
  return all;
}

/// The key of a member: its name, without the underscore that ends the name of a C++ keyword.
constexpr std::string_view key_of_member(std::string_view member) {
  return member.ends_with('_') ? member.substr(0, member.size() - 1) : member;
}

template <class T>
Json as_json(const std::optional<T>& value);
template <class T>
Json as_json(const std::vector<T>& values);

/// Any value as JSON. What is missing becomes null, and so does a number that is not finite.
template <class T>
Json as_json(const T& value) {
  if constexpr (std::is_floating_point_v<T>) {
    return std::isfinite(value) ? Json(value) : Json();
  } else {
    return Json(value);
  }
}
template <class T>
Json as_json(const std::optional<T>& value) {
  return value ? as_json(*value) : Json();
}
template <class T>
Json as_json(const std::vector<T>& values) {
  return list_of(values, [](const T& value) { return as_json(value); });
}

/// Reads a member of an object. Throws Json::exception where it is missing or of another kind.
template <class T>
void read_member(const Json& json, std::string_view key, T& value) {
  json.at(std::string(key)).get_to(value);
}
/// NOTE: a member that is missing and one that is null are the same to an optional.
template <class T>
void read_member(const Json& json, std::string_view key, std::optional<T>& value) {
  const auto found = json.find(std::string(key));
  value = found == json.end() || found->is_null() ? std::nullopt : std::optional(found->get<T>());
}

}  // namespace ricochet::report

/// What is missing becomes null.
template <class T>
struct nlohmann::adl_serializer<std::optional<T>> {
  template <class Json>
  static void to_json(Json& json, const std::optional<T>& value) {
    json = value ? Json(*value) : Json();
  }
};

/// A struct with a list of its fields is an object of them, in this order. Reading one throws
/// Json::exception where a member is missing.
template <ricochet::HasFields T>
struct nlohmann::adl_serializer<T> {
  static void to_json(ricochet::report::Json& json, const T& value) {
    json = ricochet::report::Json::object();
    visit_fields(
        [&](const ricochet::Field& field, const auto& member) {
          json[std::string(field.key)] = ricochet::report::as_json(member);
        },
        value);
  }
  static void from_json(const ricochet::report::Json& json, T& value) {
    visit_fields([&](const ricochet::Field& field,
                     auto& member) { ricochet::report::read_member(json, field.key, member); },
                 value);
  }
};

/// A list of fields that have only names. It stands after the struct, in its namespace.
#define RICOCHET_FIELDS(Type, ...)                                               \
  template <class Visit, ricochet::IsOf<Type>... Of>                             \
  void visit_fields(const Visit& visit, Of&... of) {                             \
    NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(RICOCHET_NAMED_FIELD, __VA_ARGS__)) \
  }                                                                              \
  static_assert(true)
#define RICOCHET_NAMED_FIELD(member) \
  visit(ricochet::Field{ricochet::report::key_of_member(#member)}, of.member...);
