#pragma once

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "ricochet/scene.h"

namespace ricochet::carrier_track::inline scene {

/// The values of an enumeration and their names in files and options.
template <class Value>
using EnumNames = std::vector<std::pair<std::string_view, Value>>;

const EnumNames<Centrifugal>& centrifugal_names();
const EnumNames<CountRule>& rule_names();
const EnumNames<Fidelity>& fidelity_names();
const EnumNames<ContactLaw>& contact_law_names();

/// The names of a value's enumeration.
inline const EnumNames<Centrifugal>& names_of(Centrifugal /*value*/) {
  return centrifugal_names();
}
inline const EnumNames<CountRule>& names_of(CountRule /*value*/) {
  return rule_names();
}
inline const EnumNames<Fidelity>& names_of(Fidelity /*value*/) {
  return fidelity_names();
}
inline const EnumNames<ContactLaw>& names_of(ContactLaw /*value*/) {
  return contact_law_names();
}

/// Throws std::logic_error for a value without a name.
template <class Value>
std::string_view name_of(const EnumNames<Value>& choices, Value value) {
  const auto named = std::find_if(choices.begin(), choices.end(),
                                  [&](const auto& choice) { return choice.second == value; });
  if (named == choices.end()) throw std::logic_error("a value without a name");
  return named->first;
}

}  // namespace ricochet::carrier_track::inline scene
