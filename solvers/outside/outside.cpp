#include "solvers/outside/outside.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <limits>
#include <stdexcept>
#include <utility>

#include "ricochet/error.h"
#include "solvers/outside/line_solver.h"
#include "solvers/outside/plugin.h"
#include "src/core/names.h"

namespace ricochet::outside {

namespace {

enum class Kind { name, library, program };

Kind kind_of(const std::string& text) {
  const bool has_space = text.find(' ') != std::string::npos;
  const bool is_path = text.find('/') != std::string::npos;
  std::error_code ignored;
  const bool is_file = std::filesystem::is_regular_file(text, ignored);
  if (!has_space && !is_path) {
    if (is_file && text.find('.') != std::string::npos) {
      throw InputError(text + ": a file is given with its folder, ./" + text);
    }
    return Kind::name;
  }
  if (is_path && text.ends_with(".so") && (is_file || !has_space)) return Kind::library;
  if (has_space) return Kind::program;
  if (!is_file) throw InputError(text + ": there is no such file");
  if (access(text.c_str(), X_OK) != 0) {
    throw InputError(text + ": is neither executable nor named .so; what runs it? " +
                     "For example \"python3 " + text + "\"");
  }
  return Kind::program;
}

}  // namespace

bool is_outside(const std::string& text) {
  return kind_of(text) != Kind::name;
}

std::optional<Solver> outside_solver(const std::string& text) {
  switch (kind_of(text)) {
    case Kind::library:
      return plugin(text);
    case Kind::program:
      return line_solver(text);
    default:
      return std::nullopt;
  }
}

std::optional<Solver> unstarted_solver(const std::string& text) {
  if (!is_outside(text)) return std::nullopt;
  Solver solver;
  solver.name = text;
  solver.capabilities.constraints = Capabilities::Constraints::all;
  solver.solve = [text](Evaluator&, const Vector&, Random&) -> SolverTermination {
    throw std::logic_error(text + ": was not started");
  };
  return solver;
}

namespace {

using Json = nlohmann::ordered_json;

/// Reads a point; `where` says which of a list it is.
Vector point_of(const Json& numbers, const std::string& name, Eigen::Index dimension,
                const std::string& where) {
  const std::string demand =
      fmt::format("{} must have {} number{}{}", name, dimension, dimension == 1 ? "" : "s", where);
  if (!numbers.is_array() || numbers.size() != static_cast<std::size_t>(dimension)) {
    throw InputError(demand);
  }
  Vector x(dimension);
  for (Eigen::Index i = 0; i < dimension; ++i) {
    const Json& number = numbers[static_cast<std::size_t>(i)];
    if (!number.is_number() && !number.is_null()) {
      throw InputError(
          fmt::format("{}: entry {} is of type {}", demand, i + 1, number.type_name()));
    }
    x[i] = number.is_null() ? std::numeric_limits<double>::quiet_NaN() : number.get<double>();
  }
  return x;
}

}  // namespace

AskedPoints asked_points(const Json& request, const std::string& key, Eigen::Index dimension,
                         Wanted wanted) {
  AskedPoints asked{{}, false, wanted};
  for (const auto& [name, value] : request.items()) {
    if (name == key) continue;
    if (name != "derivatives" && name != "residuals") {
      throw InputError(fmt::format("{} is not expected; {}", one_line(name),
                                   what_instead(name, {key, "derivatives", "residuals"})));
    }
    if (!value.is_boolean()) throw InputError(name + " must be true or false");
    (name == "derivatives" ? asked.wanted.derivatives : asked.wanted.residuals) = value.get<bool>();
  }
  const Json& points = request.at(key);
  asked.list = points.is_array() && !points.empty() && points[0].is_array();
  if (!asked.list) {
    asked.points.push_back(asked_point(points, key, dimension));
    return asked;
  }
  for (const Json& point : points) {
    const std::string where = fmt::format(" in point {}", asked.points.size() + 1);
    asked.points.push_back(point_of(point, key, dimension, where));
  }
  return asked;
}

Vector asked_point(const Json& numbers, const std::string& name, Eigen::Index dimension) {
  return point_of(numbers, name, dimension, "");
}

Json joined(std::vector<Json> answers, bool list) {
  if (!list) return std::move(answers.front());
  Json all = Json::object();
  for (Json& answer : answers) {
    for (auto& [key, value] : answer.items()) all[key].push_back(std::move(value));
  }
  return all;
}

}  // namespace ricochet::outside
