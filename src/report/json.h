#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

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

}  // namespace ricochet::report

/// What is missing becomes null.
template <class T>
struct nlohmann::adl_serializer<std::optional<T>> {
  template <class Json>
  static void to_json(Json& json, const std::optional<T>& value) {
    json = value ? Json(*value) : Json();
  }
};
