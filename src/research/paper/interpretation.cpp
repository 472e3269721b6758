#include "problems/carrier_track/paper/reading.h"

#include <fmt/format.h>

#include "src/core/error.h"

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
  use("the disturbance is", disturbances, &Reading::disturbance);
  use("friction multiplies", normal_forces, &Reading::normal_force);
  use("the path is", transitions, &Reading::transition);
  use("the recovery coefficient is", recoveries, &Reading::recovery);
  use("what counts", rules, &Reading::rule);
  use("the mass of the base", bases, &Reading::base);
}

}  // namespace

std::string name_of(const Reading& reading) {
  std::string name =
      fmt::format("{}-{}-{}", name_of(centrifugal_names(), reading.forcing),
                  name_of(tensions, reading.tension), name_of(units, reading.window));
  for_each_further_question([&](const char* /*question*/, const auto& choices, auto member) {
    if (reading.*member != choices.front().second) {
      name += fmt::format("-{}", name_of(choices, reading.*member));
    }
  });
  return name;
}

std::string description_of(const Reading& reading) {
  std::string text = reading.forcing == Centrifugal::projected
                         ? "centrifugal force projected on x"
                         : fmt::format("centrifugal force always {}",
                                       name_of(centrifugal_names(), reading.forcing));
  switch (reading.tension) {
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
  text += fmt::format(", a fixed number of {}", name_of(units, reading.window));
  switch (reading.disturbance) {
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
  if (reading.normal_force == NormalForce::weight) text += ", friction on the weight";
  if (reading.normal_force == NormalForce::contact) text += ", friction on a wall's own force too";
  if (reading.transition == Transition::crossing) text += ", straight crossings";
  if (reading.recovery == Recovery::hunt_crossley) text += ", Hunt-Crossley's c";
  if (reading.recovery == Recovery::contact_speed) {
    text += ", Hunt-Crossley's c with one contact speed";
  }
  if (reading.rule == Rule::peaks_1mm) text += ", peaks from 3 mm on or up to 1 mm count";
  if (reading.rule == Rule::peaks_100um) text += ", peaks from 3 mm on or up to 0.1 mm count";
  if (reading.base == Base::spindle) text += ", a base of 1.2 kg";
  return text;
}

std::vector<Answer> answers_of(const Reading& reading) {
  std::vector<Answer> answers = {
      {"the centrifugal force is", std::string(name_of(centrifugal_names(), reading.forcing))},
      {"the tension is", std::string(name_of(tensions, reading.tension))},
      {"the window is a number of", std::string(name_of(units, reading.window))}};
  for_each_further_question([&](const char* question, const auto& choices, auto member) {
    answers.push_back({question, std::string(name_of(choices, reading.*member))});
  });
  return answers;
}

std::vector<Reading> core_readings() {
  std::vector<Reading> readings;
  for (const auto& [window_name, window] : units) {
    for (const auto& [forcing_name, forcing] : centrifugal_names()) {
      for (const auto& [tension_name, tension] : tensions) {
        Reading& reading = readings.emplace_back();
        reading.forcing = forcing;
        reading.tension = tension;
        reading.window = window;
      }
    }
  }
  return readings;
}

std::vector<Reading> variations(const Reading& reading) {
  std::vector<Reading> readings;
  for_each_further_question([&](const char* /*question*/, const auto& choices, auto member) {
    for (const auto& [name, answer] : choices) {
      if (answer == reading.*member) continue;
      readings.push_back(reading);
      readings.back().*member = answer;
    }
  });
  return readings;
}

Reading find_reading(const std::string& name) {
  std::string known;
  for (const Reading& core : core_readings()) {
    const std::string core_name = name_of(core);
    known += fmt::format("{}{}", known.empty() ? "" : ", ", core_name);
    if (!name.starts_with(core_name)) continue;
    Reading reading = core;
    std::string rest = name.substr(core_name.size());
    for_each_further_question([&](const char* /*question*/, const auto& choices, auto member) {
      for (const auto& [answer_name, answer] : choices) {
        const std::string suffix = fmt::format("-{}", answer_name);
        if (!rest.starts_with(suffix) || answer == choices.front().second) continue;
        reading.*member = answer;
        rest.erase(0, suffix.size());
        break;
      }
    });
    if (rest.empty()) return reading;
  }
  std::string answers;
  for_each_further_question([&](const char* /*question*/, const auto& choices, auto member) {
    for (const auto& choice : choices) {
      if (choice.second != Reading{}.*member) answers += fmt::format(" -{}", choice.first);
    }
  });
  throw InputError(
      fmt::format("--reading {}: there is no such reading; allowed: {}; and each with "
                  "one of{}",
                  name, known, answers));
}

}  // namespace ricochet::carrier_track::inline paper
