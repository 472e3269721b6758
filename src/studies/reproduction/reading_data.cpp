#include "src/studies/reproduction/data.h"

namespace ricochet::studies::reproduction {

using namespace carrier_track;
using report::Json;

Json reading_data(const FittedReading& reading) {
  Json constants = Json::array();
  for (const Open open : open_of(reading.reading)) {
    const auto i = static_cast<std::size_t>(open);
    constants.push_back({{"name", std::string(open_constants()[i].name)},
                         {"value", reading.constants[i]},
                         {"unit", std::string(open_constants()[i].unit)},
                         {"fitted", contains(reading.freed, open)}});
  }
  const auto* turns = std::get_if<Revolutions>(&reading.scene.window);
  const auto* time = std::get_if<Seconds>(&reading.scene.window);
  return {{"name", reading.name},
          {"description", reading.description},
          {"provenance", reading.provenance},
          {"projected", reading.reading.forcing == Centrifugal::projected},
          {"tension_constant", reading.reading.tension == Tension::constant},
          {"turns", turns != nullptr ? Json(turns->count) : Json()},
          {"seconds", time != nullptr ? Json(time->count) : Json()},
          {"fitted", reading.freed.size()},
          {"constants", std::move(constants)}};
}

}  // namespace ricochet::studies::reproduction
