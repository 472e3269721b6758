#include "problems/carrier_track/scene/scene_fields.h"

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline scene {

const EnumNames<Centrifugal>& centrifugal_names() {
  static const EnumNames<Centrifugal> choices = {{"projected", Centrifugal::projected},
                                                 {"inward", Centrifugal::inward},
                                                 {"outward", Centrifugal::outward}};
  return choices;
}

const EnumNames<CountRule>& rule_names() {
  static const EnumNames<CountRule> choices = {{"impacts", CountRule::impacts},
                                               {"peaks", CountRule::peaks}};
  return choices;
}

const EnumNames<Fidelity>& fidelity_names() {
  static const EnumNames<Fidelity> choices = {{"impact", Fidelity::impact},
                                              {"compliant", Fidelity::compliant},
                                              {"planar", Fidelity::planar},
                                              {"auto", Fidelity::automatic}};
  return choices;
}

const EnumNames<ContactLaw>& contact_law_names() {
  static const EnumNames<ContactLaw> choices = {
      {"hertz", ContactLaw::hertz},
      {"kelvin-voigt", ContactLaw::kelvin_voigt},
      {"hunt-crossley", ContactLaw::hunt_crossley},
      {"lankarani-nikravesh", ContactLaw::lankarani_nikravesh},
      {"zhiying-qishao", ContactLaw::zhiying_qishao},
      {"flores", ContactLaw::flores},
      {"gonthier", ContactLaw::gonthier},
      {"exact-restitution", ContactLaw::exact_restitution}};
  return choices;
}

namespace {

/// Collects the keys of a table's fields.
struct KeyList {
  std::vector<std::string>& keys;

  template <class Member>
  void operator()(const SceneField& field, const Member& /*member*/) const {
    keys.emplace_back(field.key);
  }
  void operator()(const SceneField& field, const Walls<double>& /*member*/) const {
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
