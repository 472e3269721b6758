#include "problems/carrier_track/problems/best_known.h"

#include <fmt/format.h>

#include <utility>

#include "embedded/best_known_text.h"
#include "ricochet/error.h"
#include "src/core/suite_version.h"
#include "src/core/toml_text.h"

namespace ricochet::carrier_track::inline problems {
namespace {

BestKnown best_of(const toml::table& table, const InputError& error) {
  const auto value = table["value"].value<double>();
  const auto provenance = table["provenance"].value<std::string>();
  const toml::array* point = table["point"].as_array();
  if (!value || !provenance || point == nullptr) throw error;
  BestKnown best{*value, Vector(static_cast<Eigen::Index>(point->size())), *provenance};
  for (Eigen::Index i = 0; i < best.point.size(); ++i) {
    const auto coordinate = point->get(static_cast<std::size_t>(i))->value<double>();
    if (!coordinate) throw error;
    best.point[i] = *coordinate;
  }
  return best;
}

}  // namespace

BestValues parse_best_values(const std::string& text, const std::string& origin) {
  const toml::table file = parse_toml(text, origin);
  const auto suite = file["suite"].value<int>();
  if (suite != suite_version) {
    throw InputError(
        fmt::format("{}: best values of version {} of the suite; this is version {}: "
                    "search them again by ricochet best-values",
                    origin, suite.value_or(1), suite_version));
  }
  const auto machine = file["machine"].value<std::string>();
  if (!machine) throw InputError(origin + ": machine must be there, as a text");
  BestValues values{*machine, {}};
  for (const auto& [key, node] : file) {
    if (key.str() == "suite" || key.str() == "machine") continue;
    const InputError error(
        fmt::format("{}: {}: must be a table of value, point and provenance", origin, key.str()));
    const toml::table* table = node.as_table();
    if (table == nullptr) throw error;
    values.of.emplace(key.str(), best_of(*table, error));
  }
  return values;
}

std::string write_best_values(const BestValues& values) {
  std::string text = fmt::format(
      "# The best values known, from `ricochet best-values`.\nsuite = {}\nmachine = \"{}\"\n",
      suite_version, values.machine);
  for (const auto& [name, best] : values.of) {
    std::string point;
    for (const double x : best.point) {
      point += fmt::format("{}{}", point.empty() ? "" : ", ", toml_float(x));
    }
    text += fmt::format("\n[{}]\nvalue = {}\npoint = [{}]\nprovenance = \"{}\"\n", name,
                        toml_float(best.value), point, best.provenance);
  }
  return text;
}

const BestValues& best_values() {
  static const BestValues values = parse_best_values(
      embedded::best_known_text, "problems/carrier_track/problems/best_known.toml");
  return values;
}

void know_best(Problem& problem, const std::string& machine) {
  if (machine.empty() || machine != best_values().machine) return;
  const auto found = best_values().of.find(problem.name);
  if (found == best_values().of.end()) return;
  problem = knowing(std::move(problem), found->second);
}

Problem knowing(Problem problem, const BestKnown& best) {
  problem.best_known = best.value;
  problem.best_point = best.point;
  problem.provenance = best.provenance;
  if (problem.smoothed) {
    problem.smoothed = [smoothed = std::move(problem.smoothed), best](double smoothing) {
      return knowing(smoothed(smoothing), best);
    };
  }
  return problem;
}

}  // namespace ricochet::carrier_track::inline problems
