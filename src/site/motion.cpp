#include "src/site/motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/site/rounded.h"

namespace ricochet::site {
namespace {

/// A scene of the dynamics, without the controls at which a method failed.
Json scene_view(const Json& scene) {
  const bool chaotic = scene.at("chaotic").get<bool>();
  const double failed_at = scene.at("failed_at").get<double>();
  Json series = Json::array();
  for (const Json& exact : scene.at("exact")) {
    // It is its own reference: below all errors that are drawn.
    series.push_back({{"name", exact.at("method")},
                      {"exact", true},
                      {"points", {{rounded(exact.at("cost")), rounded(scene.at("bottom"))}}}});
  }
  for (const Json& method : scene.at("controlled")) {
    Json points = Json::array();
    for (const Json& trial : method.at("trials")) {
      if (!trial.at("error").is_number() || trial["error"].get<double>() >= failed_at) continue;
      points.push_back({rounded(trial.at("cost")), rounded(trial["error"])});
    }
    series.push_back({{"name", method.at("method")}, {"exact", false}, {"points", points}});
  }
  return {{"id", scene.at("id")},
          {"name", scene.at("name")},
          {"x", "processor time per impact [s]"},
          {"y", chaotic ? "relative error of impacts per second" : "error of impact times [s]"},
          {"y_logarithmic", true},
          {"series", series}};
}

Json middle(const Json& rows, const char* key) {
  std::vector<double> values;
  for (const Json& row : rows) {
    if (row.at(key).is_number()) values.push_back(row[key].get<double>());
  }
  if (values.empty()) return nullptr;
  std::sort(values.begin(), values.end());
  return rounded(values[values.size() / 2]);
}

/// Against hard walls in one direction: the cost of the other levels, and how often they count
/// otherwise: compliant walls by their stiffness, both directions by that of the yarn.
Json level_view(const Json& data) {
  Json series = Json::array();
  series.push_back({{"name", "hard walls"}, {"exact", true}, {"points", {{1, 0}}}});
  for (const Json& wall : data.at("fidelity").at("stiffnesses")) {
    if (!wall.at("share").is_number() || !wall.at("least_cost").is_number()) continue;
    const double cost =
        std::sqrt(wall["least_cost"].get<double>() * wall.at("most_cost").get<double>());
    series.push_back(
        {{"name", "stiffness " + wall.at("stiffness").get<std::string>()},
         {"exact", false},
         {"points", {{rounded(cost), rounded(100 * (1 - wall["share"].get<double>()))}}}});
  }
  const Json& levels = data.at("levels");
  for (const Json& direction : levels.at("directions")) {
    series.push_back({{"name", fmt::format("both directions, tan phi {:.2g}",
                                           direction.at("tangent").get<double>())},
                      {"exact", false},
                      {"points",
                       {{middle(levels.at("costs"), "planar"),
                         rounded(100 * direction.at("wrong").get<double>())}}}});
  }
  return {{"id", "levels"},
          {"name", "Levels of the model: the paper's cases"},
          {"x", "processor time over that of hard walls"},
          {"y", "counts that differ from hard walls' [%]"},
          {"y_logarithmic", false},
          {"series", series}};
}

}  // namespace

Json motion_data(const std::vector<FoundReport>& reports) {
  const FoundReport* report = first_of(reports, "dynamics");
  if (report == nullptr) return nullptr;
  Json views = Json::array();
  for (const Json& scene : report->data.at("scenes")) views.push_back(scene_view(scene));
  views.push_back(level_view(report->data));
  return {{"folder", report->folder}, {"views", views}};
}

}  // namespace ricochet::site
