#include "src/cli/asked_point.h"

#include <fmt/format.h>

#include "ricochet/error.h"
#include "src/core/near_names.h"
#include "src/core/one_line.h"
#include "src/report/json.h"

namespace ricochet::cli {
namespace {

using report::Json;

Json parse(const std::string& line) {
  try {
    return Json::parse(line);
  } catch (const Json::parse_error& error) {
    throw InputError(fmt::format("is no JSON, from byte {} on", error.byte));
  } catch (const Json::out_of_range&) {
    throw InputError("has a number that is too large");
  }
}

Vector vector_of(const Json& numbers, Eigen::Index dimension) {
  const std::string demand =
      fmt::format("x must have {} number{}", dimension, dimension == 1 ? "" : "s");
  if (!numbers.is_array() || numbers.size() != static_cast<std::size_t>(dimension)) {
    throw InputError(demand);
  }
  Vector x(dimension);
  for (Eigen::Index i = 0; i < dimension; ++i) {
    const Json& number = numbers[static_cast<std::size_t>(i)];
    if (!number.is_number()) {
      throw InputError(
          fmt::format("{}: entry {} is of type {}", demand, i + 1, number.type_name()));
    }
    x[i] = number.get<double>();
  }
  return x;
}

}  // namespace

AskedPoint parse_asked_point(const std::string& line, const Problem& problem, bool derivatives) {
  const Json json = parse(line);
  if (json.is_array()) return {vector_of(json, problem.dimension()), derivatives};
  if (!json.is_object() || !json.contains("x")) {
    throw InputError(R"(must be a point, such as [1, 2] or {"x": [1, 2]})");
  }
  AskedPoint asked{vector_of(json["x"], problem.dimension()), derivatives};
  for (const auto& [key, value] : json.items()) {
    if (key == "x") continue;
    if (key != "derivatives" && key != "residuals") {
      throw InputError(fmt::format("{} is not expected; {}", one_line(key),
                                   what_instead(key, {"x", "derivatives", "residuals"})));
    }
    if (!value.is_boolean()) throw InputError(key + " must be true or false");
    (key == "derivatives" ? asked.derivatives : asked.residuals) = value.get<bool>();
  }
  if (asked.derivatives && !problem.differentiate) {
    throw InputError("there are no derivatives in this formulation");
  }
  if (asked.residuals && !problem.residuals) {
    throw InputError("there are no residuals in this formulation");
  }
  return asked;
}

}  // namespace ricochet::cli
