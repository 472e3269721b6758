#include "problems/carrier_track/scene/scene_keys.h"

#include "problems/carrier_track/scene/scene_fields.h"
#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline scene {
namespace {

/// Collects the keys of a table's fields.
struct KeyList {
  std::vector<std::string>& keys;

  template <class Member>
  void operator()(const Field& field, const Member& /*member*/) const {
    keys.emplace_back(field.key);
  }
  void operator()(const Field& field, const Walls<double>& /*member*/) const {
    for (const char* wall : {"", "_lower", "_upper"}) keys.push_back(std::string(field.key) + wall);
  }
};

std::vector<TableKeys> collected() {
  std::vector<TableKeys> tables = {{"scene", {std::string(path_radius.key)}},
                                   {"across", {}},
                                   {"window", {"revolutions", "seconds"}},
                                   {"count", {}},
                                   {"model", {}}};
  Scene any;
  visit_scene_fields(KeyList{tables[0].second}, any);
  visit_across_fields(KeyList{tables[1].second}, any.across.emplace());
  visit_count_fields(KeyList{tables[3].second}, any);
  visit_model_fields(KeyList{tables[4].second}, any);
  return tables;
}

}  // namespace

const std::vector<TableKeys>& scene_keys() {
  static const std::vector<TableKeys> tables = collected();
  return tables;
}

}  // namespace ricochet::carrier_track::inline scene
