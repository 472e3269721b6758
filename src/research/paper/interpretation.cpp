#include "src/research/paper/interpretation.h"

#include <fmt/format.h>

#include "ricochet/error.h"

namespace ricochet::carrier_track::inline paper {
namespace {

const EnumNames<Tension> tensions = {
    {"constant", Tension::constant}, {"rotating", Tension::rotating}, {"phased", Tension::phased}};
const EnumNames<WindowUnit> units = {{"revolutions", WindowUnit::revolutions},
                                     {"seconds", WindowUnit::seconds}};
const EnumNames<DisturbanceKind> disturbances = {
    {"force", DisturbanceKind::force},
    {"acceleration", DisturbanceKind::acceleration},
    {"disturbance-frequency", DisturbanceKind::frequency},
    {"disturbance-phase", DisturbanceKind::phase}};
const EnumNames<NormalForce> normal_forces = {{"constant", NormalForce::constant},
                                              {"weight", NormalForce::weight},
                                              {"contact-friction", NormalForce::contact}};
const EnumNames<Transition> transitions = {{"plain", Transition::plain},
                                           {"crossing", Transition::crossing}};
const EnumNames<Recovery> recoveries = {{"restitution", Recovery::restitution},
                                        {"hunt-crossley", Recovery::hunt_crossley},
                                        {"contact-speed", Recovery::contact_speed}};
const EnumNames<Rule> rules = {
    {"impacts", Rule::impacts}, {"peaks-1mm", Rule::peaks_1mm}, {"peaks-0.1mm", Rule::peaks_100um}};
const EnumNames<Base> bases = {{"base-0.6kg", Base::remainder}, {"base-1.2kg", Base::spindle}};

/// Calls `use(question, choices, member)` for every question after forcing, tension and window.
template <class Use>
void for_each_further_question(Use use) {
  use("the disturbance is", disturbances, &Interpretation::disturbance);
  use("friction multiplies", normal_forces, &Interpretation::normal_force);
  use("the path is", transitions, &Interpretation::transition);
  use("the recovery coefficient is", recoveries, &Interpretation::recovery);
  use("what counts", rules, &Interpretation::rule);
  use("the mass of the base", bases, &Interpretation::base);
}

}  // namespace

std::string name_of(const Interpretation& interpretation) {
  std::string name =
      fmt::format("{}-{}-{}", name_of(centrifugal_names(), interpretation.forcing),
                  name_of(tensions, interpretation.tension), name_of(units, interpretation.window));
  for_each_further_question([&](const char* /*question*/, const auto& choices, auto member) {
    if (interpretation.*member != choices.front().second) {
      name += fmt::format("-{}", name_of(choices, interpretation.*member));
    }
  });
  return name;
}

std::string description_of(const Interpretation& interpretation) {
  std::string text = interpretation.forcing == Centrifugal::projected
                         ? "centrifugal force projected on x"
                         : fmt::format("centrifugal force always {}",
                                       name_of(centrifugal_names(), interpretation.forcing));
  switch (interpretation.tension) {
    case Tension::constant:
      text += ", constant tension";
      break;
    case Tension::rotating:
      text += ", tension that turns with the plate";
      break;
    case Tension::phased:
      text += ", tension that turns ahead of the plate";
      break;
  }
  text += fmt::format(", a fixed number of {}", name_of(units, interpretation.window));
  switch (interpretation.disturbance) {
    case DisturbanceKind::force:
      break;
    case DisturbanceKind::acceleration:
      text += ", disturbance an acceleration";
      break;
    case DisturbanceKind::frequency:
      text += ", disturbance of another frequency";
      break;
    case DisturbanceKind::phase:
      text += ", disturbance of another phase";
      break;
  }
  if (interpretation.normal_force == NormalForce::weight) text += ", friction on the weight";
  if (interpretation.normal_force == NormalForce::contact)
    text += ", friction on a wall's own force too";
  if (interpretation.transition == Transition::crossing) text += ", straight crossings";
  if (interpretation.recovery == Recovery::hunt_crossley) text += ", Hunt-Crossley's c";
  if (interpretation.recovery == Recovery::contact_speed) {
    text += ", Hunt-Crossley's c with one contact speed";
  }
  if (interpretation.rule == Rule::peaks_1mm) text += ", peaks from 3 mm on or up to 1 mm count";
  if (interpretation.rule == Rule::peaks_100um)
    text += ", peaks from 3 mm on or up to 0.1 mm count";
  if (interpretation.base == Base::spindle) text += ", a base of 1.2 kg";
  return text;
}

std::vector<Answer> answers_of(const Interpretation& interpretation) {
  std::vector<Answer> answers = {
      {"the centrifugal force is",
       std::string(name_of(centrifugal_names(), interpretation.forcing))},
      {"the tension is", std::string(name_of(tensions, interpretation.tension))},
      {"the window is a number of", std::string(name_of(units, interpretation.window))}};
  for_each_further_question([&](const char* question, const auto& choices, auto member) {
    answers.push_back({question, std::string(name_of(choices, interpretation.*member))});
  });
  return answers;
}

std::vector<Interpretation> core_interpretations() {
  std::vector<Interpretation> interpretations;
  for (const auto& [window_name, window] : units) {
    for (const auto& [forcing_name, forcing] : centrifugal_names()) {
      for (const auto& [tension_name, tension] : tensions) {
        Interpretation& interpretation = interpretations.emplace_back();
        interpretation.forcing = forcing;
        interpretation.tension = tension;
        interpretation.window = window;
      }
    }
  }
  return interpretations;
}

std::vector<Interpretation> variations(const Interpretation& interpretation) {
  std::vector<Interpretation> interpretations;
  for_each_further_question([&](const char* /*question*/, const auto& choices, auto member) {
    for (const auto& [name, answer] : choices) {
      if (answer == interpretation.*member) continue;
      interpretations.push_back(interpretation);
      interpretations.back().*member = answer;
    }
  });
  return interpretations;
}

Interpretation find_interpretation(const std::string& name) {
  std::string known;
  for (const Interpretation& core : core_interpretations()) {
    const std::string core_name = name_of(core);
    known += fmt::format("{}{}", known.empty() ? "" : ", ", core_name);
    if (!name.starts_with(core_name)) continue;
    Interpretation interpretation = core;
    std::string rest = name.substr(core_name.size());
    for_each_further_question([&](const char* /*question*/, const auto& choices, auto member) {
      for (const auto& [answer_name, answer] : choices) {
        const std::string suffix = fmt::format("-{}", answer_name);
        if (!rest.starts_with(suffix) || answer == choices.front().second) continue;
        interpretation.*member = answer;
        rest.erase(0, suffix.size());
        break;
      }
    });
    if (rest.empty()) return interpretation;
  }
  std::string answers;
  for_each_further_question([&](const char* /*question*/, const auto& choices, auto member) {
    for (const auto& choice : choices) {
      if (choice.second != Interpretation{}.*member) answers += fmt::format(" -{}", choice.first);
    }
  });
  throw InputError(fmt::format(
      "--interpretation {}: there is no such interpretation; allowed: {}; and each with "
      "one of{}",
      name, known, answers));
}

}  // namespace ricochet::carrier_track::inline paper
