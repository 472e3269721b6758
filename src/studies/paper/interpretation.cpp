#include "src/studies/paper/interpretation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "embedded/default_interpretation_text.h"
#include "ricochet/error.h"
#include "src/core/toml_fields.h"
#include "src/studies/paper/theory.h"

namespace ricochet::carrier_track::inline paper {

namespace {

/// An answer to a question: its name, and what a description says of it.
template <class Value>
struct Choice {
  std::string_view name;
  Value value;
  std::string_view words = {};
};

template <class Value>
using Choices = std::vector<Choice<Value>>;

const Choices<Centrifugal> forcings = {
    {"projected", Centrifugal::projected, "centrifugal force projected on x"},
    {"inward", Centrifugal::inward, "centrifugal force always inward"},
    {"outward", Centrifugal::outward, "centrifugal force always outward"}};
const Choices<Tension> tensions = {
    {"constant", Tension::constant, ", constant tension"},
    {"rotating", Tension::rotating, ", tension that turns with the plate"},
    {"phased", Tension::phased, ", tension that turns ahead of the plate"}};
const Choices<WindowUnit> windows = {
    {"revolutions", WindowUnit::revolutions, ", a fixed number of revolutions"},
    {"seconds", WindowUnit::seconds, ", a fixed number of seconds"}};
const Choices<DisturbanceKind> disturbances = {
    {"force", DisturbanceKind::force},
    {"acceleration", DisturbanceKind::acceleration, ", disturbance an acceleration"},
    {"disturbance-frequency", DisturbanceKind::frequency, ", disturbance of another frequency"},
    {"disturbance-phase", DisturbanceKind::phase, ", disturbance of another phase"}};
const Choices<NormalForce> normal_forces = {
    {"constant", NormalForce::constant},
    {"weight", NormalForce::weight, ", friction on the weight"},
    {"contact-friction", NormalForce::contact, ", friction on a wall's own force too"}};
const Choices<Transition> transitions = {
    {"plain", Transition::plain}, {"crossing", Transition::crossing, ", straight crossings"}};
const Choices<Recovery> recoveries = {
    {"restitution", Recovery::restitution},
    {"hunt-crossley", Recovery::hunt_crossley, ", Hunt-Crossley's c"},
    {"contact-speed", Recovery::contact_speed, ", Hunt-Crossley's c with one contact speed"}};
const Choices<Rule> rules = {
    {"impacts", Rule::impacts},
    {"peaks-1mm", Rule::peaks_1mm, ", peaks from 3 mm on or up to 1 mm count"},
    {"peaks-0.1mm", Rule::peaks_100um, ", peaks from 3 mm on or up to 0.1 mm count"}};
const Choices<Base> bases = {{"base-0.6kg", Base::remainder},
                             {"base-1.2kg", Base::spindle, ", a base of 1.2 kg"}};
const Choices<Counted> countings = {
    {"from-start", Counted::from_start},
    {"later-window", Counted::later, ", counted from a later turn on"},
    {"long-run", Counted::long_run, ", as many a turn as in the long run"}};

/// Calls `use(question, is_named, choices, member)` for every question. The answers to the first
/// three are always part of a name, the first answers to the others never.
template <class Use>
void for_each_question(Use use) {
  use("the centrifugal force is", true, forcings, &Interpretation::forcing);
  use("the tension is", true, tensions, &Interpretation::tension);
  use("the window is a number of", true, windows, &Interpretation::window);
  use("the disturbance is", false, disturbances, &Interpretation::disturbance);
  use("friction multiplies", false, normal_forces, &Interpretation::normal_force);
  use("the path is", false, transitions, &Interpretation::transition);
  use("the recovery coefficient is", false, recoveries, &Interpretation::recovery);
  use("what counts", false, rules, &Interpretation::rule);
  use("the mass of the base", false, bases, &Interpretation::base);
  use("collisions are counted", false, countings, &Interpretation::counted);
}

/// Returns true if no answer excludes another: turns a to b are turns.
bool is_possible(const Interpretation& interpretation) {
  return interpretation.counted != Counted::later ||
         interpretation.window == WindowUnit::revolutions;
}

/// Calls `use(question, choice, is_in_name)` for the interpretation's answer to every question.
template <class Use>
void for_each_answer(const Interpretation& interpretation, Use use) {
  for_each_question([&](const char* question, bool is_named, const auto& choices, auto member) {
    for (const auto& choice : choices) {
      if (choice.value != interpretation.*member) continue;
      use(question, choice, is_named || &choice != &choices.front());
    }
  });
}

}  // namespace

std::string name_of(const Interpretation& interpretation) {
  std::string name;
  for_each_answer(interpretation, [&](const char*, const auto& choice, bool is_in_name) {
    if (is_in_name) name += fmt::format("{}{}", name.empty() ? "" : "-", choice.name);
  });
  return name;
}

std::string description_of(const Interpretation& interpretation) {
  std::string text;
  for_each_answer(interpretation,
                  [&](const char*, const auto& choice, bool) { text += choice.words; });
  return text;
}

std::vector<Answer> answers_of(const Interpretation& interpretation) {
  std::vector<Answer> answers;
  for_each_answer(interpretation, [&](const char* question, const auto& choice, bool) {
    answers.push_back({question, std::string(choice.name)});
  });
  return answers;
}

std::vector<Interpretation> core_interpretations() {
  std::vector<Interpretation> interpretations;
  for (const auto& window : windows) {
    for (const auto& forcing : forcings) {
      for (const auto& tension : tensions) {
        interpretations.push_back({forcing.value, tension.value, window.value});
      }
    }
  }
  return interpretations;
}

std::vector<Interpretation> variations(const Interpretation& interpretation) {
  std::vector<Interpretation> interpretations;
  for_each_question([&](const char*, bool is_named, const auto& choices, auto member) {
    for (const auto& choice : choices) {
      if (is_named || choice.value == interpretation.*member) continue;
      Interpretation varied = interpretation;
      varied.*member = choice.value;
      if (is_possible(varied)) interpretations.push_back(varied);
    }
  });
  return interpretations;
}

Interpretation find_interpretation(const std::string& name) {
  Interpretation interpretation;
  std::string rest = "-" + name;
  std::string further;
  for_each_question([&](const char*, bool is_named, const auto& choices, auto member) {
    bool found = false;
    for (const auto& choice : choices) {
      if (!is_named && &choice == &choices.front()) continue;
      const std::string part = fmt::format("-{}", choice.name);
      if (!is_named) further += " " + part;
      if (found || !rest.starts_with(part)) continue;
      interpretation.*member = choice.value;
      rest.erase(0, part.size());
      found = true;
    }
    if (is_named && !found) rest = "?";  // no later part fits it
  });
  if (rest.empty() && is_possible(interpretation)) return interpretation;
  if (rest.empty()) {
    throw InputError(fmt::format(
        "--interpretation {}: a window that begins later must be a number of revolutions", name));
  }
  std::vector<std::string> known;
  for (const Interpretation& core : core_interpretations()) known.push_back(name_of(core));
  throw InputError(fmt::format(
      "--interpretation {}: there is no such interpretation; allowed: {}; and each with "
      "one of{}",
      name, fmt::join(known, ", "), further));
}

double value_at(const UnknownParameter& c, double share) {
  if (c.logarithmic) return c.lower * std::pow(c.upper / c.lower, share);
  return c.lower + share * (c.upper - c.lower);
}

double share_of(const UnknownParameter& c, double value) {
  const double share = c.logarithmic ? std::log(value / c.lower) / std::log(c.upper / c.lower)
                                     : (value - c.lower) / (c.upper - c.lower);
  return std::clamp(share, 0.0, 1.0);
}

const std::vector<UnknownParameter>& unknown_parameters() {
  constexpr double turn = 2 * std::numbers::pi;
  static const std::vector<UnknownParameter> constants = {
      {"pull", "N", 0.01, 40, true, 0.01,
       "a yarn is braided under some newtons; drawn straight across the track, it has none along "
       "x"},
      {"normal_force", "N", 0.01, 60, true, 1.2 * gravity,
       "to five times the weight m g, which is natural"},
      {"centrifugal_mass_radius", "kg m", 0.01, 2.4, true, 0.078,
       "1.2 kg from a slider's arm, 8 mm, to the radius of a machine, 2 m; m r_c is natural"},
      {"clearance", "m", 5e-5, 1e-2, true, 2e-3,
       "from a tight fit to the play of a worn track; 2 mm lie between the limits of (33)"},
      {"start_share", "", 0, 1, false, 0.5, "of the clearance; in the middle is natural"},
      {"start_velocity", "m/s", -0.6, 0.6, false, 0.0,
       "no faster than the carrier goes round at 9 rad/s; at rest is natural"},
      {"phase", "rad", 0, turn, false, 0.0, "any angle; (31) starts at 0"},
      {"revolutions", "turns", 0.3, 4, true, 1.0, "from a part of a turn to some; one is natural"},
      {"seconds", "s", 0.3, 8, true, turn, "as long as a turn at 0.8 to 20 rad/s; at 1 rad/s"},
      {"counting_limit", "m/s", 1e-7, 0.2, true, std::nullopt,
       "from what a computation resolves to what is heard"},
      {"pull_phase", "rad", 0, turn, false, 0.0, "any angle"},
      {"disturbance_frequency", "rad/s", 0.3, 60, true, 1.0,
       "from the slowest to the fastest shaft; the paper's is 1"},
      {"disturbance_phase", "rad", 0, turn, false, 0.0, "any angle; the paper's is 0"},
      {"crossing_angle", "rad", 0.05, 0.8, false, 0.4,
       "of the plate, half a crossing: no crossing is longer than half the half turn"},
      {"contact_speed", "m/s", 1e-3, 1, true, 0.1, "as fast as impacts are"},
      {"first_turn", "turns", 0, 10, false, 0.0,
       "until the start is forgotten; from the start on is natural"}};
  return constants;
}

std::vector<Unknown> unknowns_of(const Interpretation& interpretation) {
  const bool impacts = interpretation.rule == Rule::impacts;
  const bool forgets_start = interpretation.counted == Counted::long_run;
  const auto used = [&](Unknown open) {
    switch (open) {
      case Unknown::normal_force:
        return interpretation.normal_force != NormalForce::weight;
      case Unknown::revolutions:
        return interpretation.window == WindowUnit::revolutions;
      case Unknown::seconds:
        return interpretation.window == WindowUnit::seconds;
      case Unknown::counting_limit:
        return impacts;
      case Unknown::pull_phase:
        return interpretation.tension == Tension::phased;
      case Unknown::disturbance_frequency:
        return interpretation.disturbance == DisturbanceKind::frequency;
      case Unknown::disturbance_phase:
        return interpretation.disturbance == DisturbanceKind::phase;
      case Unknown::crossing_angle:
        return interpretation.transition == Transition::crossing;
      case Unknown::contact_speed:
        return interpretation.recovery == Recovery::contact_speed;
      case Unknown::first_turn:
        return interpretation.counted == Counted::later;
      case Unknown::start_share:
      case Unknown::start_velocity:
      case Unknown::phase:
        return !forgets_start;
      default:
        return true;
    }
  };
  std::vector<Unknown> open;
  for (std::size_t i = 0; i < unknown_size; ++i) {
    if (used(static_cast<Unknown>(i))) open.push_back(static_cast<Unknown>(i));
  }
  return open;
}

bool contains(const std::vector<Unknown>& constants, Unknown constant) {
  return std::find(constants.begin(), constants.end(), constant) != constants.end();
}

Constants natural_constants() {
  Constants constants{};
  for (std::size_t i = 0; i < unknown_size; ++i) {
    const UnknownParameter& c = unknown_parameters()[i];
    const bool searched = !c.natural || (c.logarithmic && *c.natural == c.lower);
    constants[i] = searched ? std::sqrt(c.lower * c.upper) : *c.natural;
  }
  return constants;
}

Scene scene_at(const Scene& scene, const Interpretation& interpretation, const Constants& constants,
               double omega) {
  Scene result = at_speed(scene, omega);
  if (interpretation.transition == Transition::crossing) {
    const double turns = interpretation.window == WindowUnit::revolutions
                             ? std::get<Revolutions>(scene.window).count
                             : omega * std::get<Seconds>(scene.window).count / 6.0;
    result.profile = crossing_profile(
        omega, constants[static_cast<std::size_t>(Unknown::crossing_angle)], turns);
  }
  return result;
}

namespace {

/// Default speed of a scene: the quiet one of the paper's Figure 5 [rad/s].
constexpr double usual_speed = 3.0;

}  // namespace

bool is_one_scene(const Interpretation& interpretation) {
  return interpretation.transition == Transition::plain &&
         interpretation.recovery == Recovery::restitution &&
         interpretation.disturbance != DisturbanceKind::acceleration &&
         interpretation.counted == Counted::from_start;
}

FittedInterpretation fitted_interpretation(const Parameterisation& fit, std::string provenance,
                                           const std::string& origin) {
  const Interpretation& interpretation = fit.interpretation;
  if (!is_one_scene(interpretation)) {
    throw InputError(
        fmt::format("{}: interpretation = {}: must be one whose cases differ in restitution, "
                    "friction and disturbance alone",
                    origin, name_of(interpretation)));
  }
  FittedInterpretation fitted{fit, std::move(provenance), name_of(interpretation),
                              description_of(interpretation),
                              scene_of(find_case("C1"), interpretation, fit.constants)};
  fitted.scene.omega = usual_speed;
  return fitted;
}

FittedInterpretation parse_fitted_interpretation(const std::string& text,
                                                 const std::string& origin) {
  const toml::table table = parse_toml(text, origin);
  const TomlTable file(&table, origin);
  file.refuse_others_than({"interpretation", "provenance", "fitted", "fixed"});
  const auto text_at = [&](std::string_view key) {
    std::string found;
    FieldReader{file}(Field{key, "", "", {}, Presence::required}, found);
    return found;
  };
  const Interpretation interpretation = find_interpretation(text_at("interpretation"));
  Constants constants = natural_constants();
  std::vector<Unknown> free;
  const TomlTable fitted(table["fitted"].as_table(), origin, "fitted.");
  const TomlTable fixed(table["fixed"].as_table(), origin, "fixed.");
  std::vector<std::string> names;
  for (const Unknown open : unknowns_of(interpretation)) {
    const auto i = static_cast<std::size_t>(open);
    const UnknownParameter& c = unknown_parameters()[i];
    names.emplace_back(c.name);
    const bool is_fitted = fitted.has(c.name);
    if (is_fitted == fixed.has(c.name)) {
      throw InputError(
          fmt::format("{}: {} must be in one of [fitted] and [fixed]", origin, c.name));
    }
    if (is_fitted) free.push_back(open);
    const std::string allowed = fmt::format("within {}..{} [{}]", c.lower, c.upper, c.unit);
    const Range range{.least = c.lower, .most = c.upper, .words = allowed};
    FieldReader{is_fitted ? fitted : fixed}(Field{c.name, c.unit, "", range}, constants[i]);
  }
  fitted.refuse_others_than(names);
  fixed.refuse_others_than(names);
  return fitted_interpretation({interpretation, std::move(free), constants}, text_at("provenance"),
                               origin);
}

std::string write_fitted_interpretation(const FittedInterpretation& fitted) {
  std::string text =
      fmt::format("interpretation = \"{}\"\nprovenance = \"{}\"\n", fitted.name, fitted.provenance);
  for (const bool wanted : {true, false}) {
    text += wanted ? "\n[fitted]\n" : "\n[fixed]\n";
    for (const Unknown open : unknowns_of(fitted.interpretation)) {
      if (contains(fitted.free, open) != wanted) continue;
      const auto i = static_cast<std::size_t>(open);
      text += fmt::format("{} = {}  # {}\n", unknown_parameters()[i].name,
                          toml_float(fitted.constants[i]), unknown_parameters()[i].unit);
    }
  }
  return text;
}

const FittedInterpretation& default_interpretation() {
  static const FittedInterpretation interpretation = parse_fitted_interpretation(
      embedded::default_interpretation_text, "src/studies/paper/interpretation.toml");
  return interpretation;
}

}  // namespace ricochet::carrier_track::inline paper
