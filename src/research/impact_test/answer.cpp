#include "src/research/impact_test/answer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/core/one_line.h"

namespace ricochet::studies::impact_test {
namespace {

using carrier_track::Impact;
using report::Json;

/// The keys of the endings that have a reason.
constexpr std::array<std::pair<const char*, Ending>, 3> reasons = {
    {{"cannot", Ending::cannot}, {"error", Ending::error}, {"never", Ending::never}}};

constexpr std::size_t shown_of_a_line = 80;  // bytes

Impact impact_in(const Json& json) {
  const double time = json.at(0).get<double>();
  const auto wall = json.at(1).get<std::string>();
  const double speed = json.at(2).get<double>();
  if (wall != "lower" && wall != "upper") throw std::runtime_error("no wall \"" + wall + "\"");
  if (!std::isfinite(time) || !std::isfinite(speed)) throw std::runtime_error("an impact is NaN");
  return {time, wall == "upper" ? Wall::upper : Wall::lower, speed};
}

Answer read(const Json& json, const std::string& scene) {
  Answer answer{scene};
  for (const auto& [key, ending] : reasons) {
    if (!json.contains(key)) continue;
    answer.ending = ending;
    answer.reason = one_line(json.at(key).get<std::string>());
    return answer;
  }
  if (json.contains("scene") && json.at("scene") != scene) {
    throw std::runtime_error("an answer for another scene, " + json.at("scene").dump());
  }
  for (const Json& impact : json.at("impacts")) answer.impacts.push_back(impact_in(impact));
  std::ranges::stable_sort(answer.impacts, {}, &Impact::time);
  answer.seconds = json.at("seconds").get<double>();
  answer.deepest = json.value("deepest", 0.0);
  if (!(answer.seconds >= 0) || !(answer.deepest >= 0)) {
    throw std::runtime_error("seconds and deepest must be numbers >= 0");
  }
  return answer;
}

}  // namespace

Answer answer_in(std::string_view line, const std::string& scene) {
  try {
    return read(Json::parse(line), scene);
  } catch (const std::exception& error) {
    return {
        scene, Ending::error,
        one_line(fmt::format("no answer: {}; {}", error.what(), line.substr(0, shown_of_a_line)))};
  }
}

std::string line_of(const Answer& answer) {
  Json json = {{"scene", answer.scene}};
  for (const auto& [key, ending] : reasons) {
    if (answer.ending == ending) json[key] = answer.reason;
  }
  if (answer.ending == Ending::answered) {
    json["impacts"] = report::list_of(answer.impacts, [](const Impact& i) -> Json {
      return {i.time, i.wall == Wall::upper ? "upper" : "lower", i.speed};
    });
    json["seconds"] = answer.seconds;
    json["deepest"] = answer.deepest;
  }
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace ricochet::studies::impact_test
