#pragma once

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "problems/carrier_track/scene.h"

namespace ricochet::carrier_track {

/// The values of an enumeration by the names that a user writes for them.
template <class Value>
using Choices = std::vector<std::pair<std::string_view, Value>>;

const Choices<Centrifugal>& centrifugal_choices();
const Choices<CountRule>& rule_choices();
const Choices<Fidelity>& fidelity_choices();
const Choices<ContactLaw>& contact_law_choices();

/// Throws std::logic_error for a value without a name.
template <class Value>
std::string_view name_of(const Choices<Value>& choices, Value value) {
  const auto named = std::find_if(choices.begin(), choices.end(),
                                  [&](const auto& choice) { return choice.second == value; });
  if (named == choices.end()) throw std::logic_error("a value without a name");
  return named->first;
}

}  // namespace ricochet::carrier_track
