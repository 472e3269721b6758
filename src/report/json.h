#pragma once

#include <nlohmann/json.hpp>
#include <optional>

namespace ricochet::report {

/// What a report is drawn from: the results of a study, in the order in which they were computed.
/// Numbers keep all their digits; what is missing is null.
using Json = nlohmann::ordered_json;

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

}  // namespace ricochet::report
