#include "src/research/paper/fitted_interpretation.h"

#include <fmt/format.h>

#include "embedded/default_interpretation_text.h"
#include "problems/carrier_track/scene/toml_table.h"
#include "ricochet/error.h"
#include "src/core/toml_text.h"

namespace ricochet::carrier_track::inline paper {
namespace {

/// Default speed of a scene: the quiet one of the paper's Figure 5 [rad/s].
constexpr double usual_speed = 3.0;

}  // namespace

bool is_one_scene(const Interpretation& interpretation) {
  return interpretation.transition == Transition::plain &&
         interpretation.recovery == Recovery::restitution &&
         interpretation.disturbance != DisturbanceKind::acceleration;
}

FittedInterpretation fitted_interpretation(const Interpretation& interpretation,
                                           const Constants& constants, std::vector<Unknown> free,
                                           std::string provenance, const std::string& origin) {
  if (!is_one_scene(interpretation)) {
    throw InputError(
        fmt::format("{}: interpretation = {}: must be one whose cases differ in restitution, "
                    "friction and disturbance alone",
                    origin, name_of(interpretation)));
  }
  FittedInterpretation fitted{interpretation,
                              constants,
                              std::move(free),
                              std::move(provenance),
                              name_of(interpretation),
                              description_of(interpretation),
                              scene_of(find_case("C1"), interpretation, constants)};
  fitted.scene.omega = usual_speed;
  return fitted;
}

FittedInterpretation parse_fitted_interpretation(const std::string& text,
                                                 const std::string& origin) {
  const toml::table file = parse_toml(text, origin);
  const auto name = file["interpretation"].value<std::string>();
  const auto provenance = file["provenance"].value<std::string>();
  if (!name || !provenance) {
    throw InputError(origin + ": interpretation and provenance must be there, as texts");
  }
  const Interpretation interpretation = find_interpretation(*name);
  Constants constants = natural_constants();
  std::vector<Unknown> free;
  Uncertain uncertain;
  TomlTable fitted(file, "fitted", origin, uncertain);
  TomlTable fixed(file, "fixed", origin, uncertain);
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
    (is_fitted ? fitted : fixed).number({c.name, c.unit}, constants[i]);
    if (constants[i] < c.lower || constants[i] > c.upper) {
      throw InputError(fmt::format("{}: {} = {}: must be within {}..{} [{}]", origin, c.name,
                                   constants[i], c.lower, c.upper, c.unit));
    }
  }
  fitted.refuse_others_than(names);
  fixed.refuse_others_than(names);
  return fitted_interpretation(interpretation, constants, std::move(free), *provenance, origin);
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
      embedded::default_interpretation_text, "src/research/paper/interpretation.toml");
  return interpretation;
}

}  // namespace ricochet::carrier_track::inline paper
