#include "problems/carrier_track/scene/enum_names.h"

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

}  // namespace ricochet::carrier_track::inline scene
