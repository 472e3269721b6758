#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "problems/own/program.h"
#include "ricochet/error.h"
#include "solvers/outside/outside.h"
#include "src/core/names.h"

namespace ricochet::own {

namespace {

using Json = nlohmann::ordered_json;

Eigen::Index count(std::size_t size) {
  return static_cast<Eigen::Index>(size);
}

double binary(double value) {
  return std::isnan(value) ? missing : value <= 0 ? 0 : 1;
}

void read(const Json& answer, const std::string& key, Vector& target) {
  if (!answer.contains(key)) throw InputError(key + " is missing");
  Json list = answer[key];
  if (list.is_array()) {
    for (Json& entry : list) {
      if (entry.is_boolean()) entry = entry.get<bool>() ? 0 : 1;  // of a binary constraint
    }
  }
  target = outside::asked_point(list, key, target.size());
}

void read(const Json& answer, const std::string& key, Rows& target) {
  if (!answer.contains(key) || !answer[key].is_array() ||
      count(answer[key].size()) != target.rows()) {
    throw InputError(fmt::format("{} must have {} rows", key, target.rows()));
  }
  for (Eigen::Index i = 0; i < target.rows(); ++i) {
    target.row(i) = outside::asked_point(answer[key][static_cast<std::size_t>(i)],
                                         fmt::format("row {} of {}", i + 1, key), target.cols());
  }
}

Given values_in(const ProblemFile& file, const Json& answer, bool derivatives) {
  static const std::vector<std::string> keys = {"objective", "constraints", "gradient",
                                                "jacobian",  "residuals",   "residual_jacobian",
                                                "error"};
  for (const auto& [key, value] : answer.items()) {
    // `ricochet evaluate` itself may be the program.
    if (key == "true_values" || key == "evaluations") continue;
    if (std::find(keys.begin(), keys.end(), key) == keys.end())
      throw InputError(
          fmt::format("{} is not expected; {}", one_line(key), what_instead(key, keys)));
  }
  if (answer.contains("error")) {
    const Json& error = answer["error"];
    throw std::runtime_error("said: " +
                             one_line(error.is_string() ? error.get<std::string>() : error.dump()));
  }
  Given given = nothing_given(file, derivatives);
  const bool has_residuals = given.residuals.size() > 0;
  if (has_residuals) read(answer, "residuals", given.residuals);
  if (has_residuals && !answer.contains("objective")) {
    given.objective = half_sum_of_squares(given.residuals);
  } else {
    if (!answer.contains("objective")) throw InputError("objective is missing");
    given.objective = outside::asked_point(Json::array({answer["objective"]}), "objective", 1)[0];
  }
  if (!file.constraints.empty()) read(answer, "constraints", given.constraints);
  make_binary(file, given.constraints);
  if (!derivatives) return given;
  read(answer, "gradient", given.gradient);
  if (!file.constraints.empty()) read(answer, "jacobian", given.jacobian);
  if (has_residuals) read(answer, "residual_jacobian", given.residual_jacobian);
  return given;
}

/// A number as C, Fortran and others write it; NaN for one of the spellings of none: nan,
/// -nan(ind), 1.#QNAN.
std::optional<double> number_in(std::string word) {
  for (char& letter : word) {
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    if (letter == 'd') letter = 'e';
  }
  if (word.starts_with('+')) word.erase(0, 1);
  if (const auto number = number_of_text<double>(word)) return number;
  if (word.starts_with('-')) word.erase(0, 1);
  const bool none = word.starts_with("nan") || word.find('#') != std::string::npos;
  return none ? std::optional(missing) : std::nullopt;
}

/// The numbers of a text; a word may stand after one that is alone on its line.
std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::replace_if(
        line.begin(), line.end(), [](char c) { return c == ',' || c == ';'; }, ' ');
    std::istringstream words(line);
    std::size_t of_line = 0;
    for (std::string word; words >> word; ++of_line) {
      if (const auto number = number_in(word)) {
        numbers.push_back(*number);
      } else if (of_line != 1 || words >> word) {
        throw InputError("gave \"" + one_line(word.substr(0, 80)) + "\", which is no number");
      }
    }
  }
  return numbers;
}

}  // namespace

void make_binary(const ProblemFile& file, Vector& constraints) {
  for (std::size_t i = 0; i < file.constraints.size(); ++i) {
    if (file.constraints[i].kind != ConstraintKind::binary) continue;
    double& value = constraints[count(i)];
    value = binary(value);
  }
}

double half_sum_of_squares(const Vector& residuals) {
  return residuals.squaredNorm() / 2;
}

Given given_in_line(const ProblemFile& file, std::string_view line, bool derivatives) {
  const auto shown = [&] { return one_line(line.substr(0, 80)) + (line.size() > 80 ? "..." : ""); };
  Json answer;
  try {
    answer = Json::parse(line);
  } catch (const Json::out_of_range&) {
    throw InputError("answered with a number that is too large: " + shown());
  } catch (const Json::exception&) {
    throw InputError("answered with what is no JSON: " + shown());
  }
  if (!answer.is_object()) {
    throw InputError("answered with what is no JSON object: " + shown());
  }
  try {
    return values_in(file, answer, derivatives);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", error.what(), shown()));
  }
}

Given given_in_numbers(const ProblemFile& file, const std::string& text) {
  const std::vector<double> numbers = numbers_in(text);
  const std::vector<std::string>& outputs = file.program.outputs;
  Given given = nothing_given(file, false);
  const auto size_of = [&](const std::string& name) {
    return name == "residuals" ? static_cast<std::size_t>(given.residuals.size()) : 1;
  };
  std::size_t expected = 0;
  for (const std::string& name : outputs) expected += size_of(name);
  if (numbers.size() != expected) {
    throw InputError(fmt::format("gave {} numbers, not {}: {}", numbers.size(), expected,
                                 fmt::join(outputs, ", ")));
  }
  std::size_t at = 0;
  for (const std::string& name : outputs) {
    const auto values = Eigen::Map<const Vector>(&numbers[at], count(size_of(name)));
    at += size_of(name);
    if (name == "objective") given.objective = values[0];
    if (name == "residuals") given.residuals = values;
    for (std::size_t i = 0; i < file.constraints.size(); ++i) {
      if (file.constraints[i].name == name) given.constraints[count(i)] = values[0];
    }
  }
  if (std::find(outputs.begin(), outputs.end(), "objective") == outputs.end()) {
    given.objective = half_sum_of_squares(given.residuals);
  }
  make_binary(file, given.constraints);
  return given;
}

}  // namespace ricochet::own
