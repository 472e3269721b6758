#pragma once

#include <nlohmann/json.hpp>
#include <optional>

namespace ricochet::cli {

enum class Format { text, json };

/// JSON with its keys in the order written.
using Json = nlohmann::ordered_json;

/// The value, or null.
template <class T>
Json json_of(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

}  // namespace ricochet::cli
