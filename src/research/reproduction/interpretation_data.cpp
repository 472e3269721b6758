#include "src/research/reproduction/data.h"

namespace ricochet::studies::reproduction {

using namespace carrier_track;
using report::Json;

Json interpretation_data(const FittedInterpretation& interpretation) {
  Json constants = Json::array();
  for (const Unknown open : unknowns_of(interpretation.interpretation)) {
    const auto i = static_cast<std::size_t>(open);
    constants.push_back({{"name", std::string(unknown_parameters()[i].name)},
                         {"value", interpretation.constants[i]},
                         {"unit", std::string(unknown_parameters()[i].unit)},
                         {"fitted", contains(interpretation.free, open)}});
  }
  const auto* turns = std::get_if<Revolutions>(&interpretation.scene.window);
  const auto* time = std::get_if<Seconds>(&interpretation.scene.window);
  return {{"name", interpretation.name},
          {"description", interpretation.description},
          {"provenance", interpretation.provenance},
          {"projected", interpretation.interpretation.forcing == Centrifugal::projected},
          {"tension_constant", interpretation.interpretation.tension == Tension::constant},
          {"turns", turns != nullptr ? Json(turns->count) : Json()},
          {"seconds", time != nullptr ? Json(time->count) : Json()},
          {"fitted", interpretation.free.size()},
          {"constants", std::move(constants)}};
}

}  // namespace ricochet::studies::reproduction
