#include "problems/carrier_track/choices.h"

namespace ricochet::carrier_track {

const Choices<Centrifugal>& centrifugal_choices() {
  static const Choices<Centrifugal> choices = {{"projected", Centrifugal::projected},
                                               {"inward", Centrifugal::inward},
                                               {"outward", Centrifugal::outward}};
  return choices;
}

const Choices<CountRule>& rule_choices() {
  static const Choices<CountRule> choices = {{"impacts", CountRule::impacts},
                                             {"peaks", CountRule::peaks}};
  return choices;
}

const Choices<Fidelity>& fidelity_choices() {
  static const Choices<Fidelity> choices = {{"impact", Fidelity::impact},
                                            {"compliant", Fidelity::compliant},
                                            {"planar", Fidelity::planar},
                                            {"auto", Fidelity::automatic}};
  return choices;
}

const Choices<ContactLaw>& contact_law_choices() {
  static const Choices<ContactLaw> choices = {
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

}  // namespace ricochet::carrier_track
