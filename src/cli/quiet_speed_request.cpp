#include "src/cli/quiet_speed_request.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "src/core/error.h"

namespace ricochet::cli {
namespace {

using carrier_track::Limit;
using carrier_track::Measure;

std::optional<Limit> limit_of(const QuietSpeedRequest& request) {
  const std::pair<Measure, std::optional<double>> asked[] = {
      {Measure::collisions, request.allow},
      {Measure::collisions_per_turn, request.allow_per_turn},
      {Measure::energy, request.allow_energy},
      {Measure::impact_speed, request.allow_speed}};
  std::optional<Limit> limit;
  for (const auto& [measure, at_most] : asked) {
    if (!at_most) continue;
    if (limit) {
      throw InputError("--allow, --allow-per-turn, --allow-energy, --allow-speed: one at a time");
    }
    if (!(*at_most >= 0 && std::isfinite(*at_most))) {
      throw InputError(fmt::format("what is allowed is {}: must be finite and >= 0", *at_most));
    }
    limit = {measure, *at_most};
  }
  return limit;
}

}  // namespace

carrier_track::QuietSpeedOptions options_of(const QuietSpeedRequest& request) {
  if (!(request.fastest >= 0.1 && request.fastest <= 1000)) {
    throw InputError(
        fmt::format("--fastest {}: must be within 0.1..1000 [rad/s]", request.fastest));
  }
  if (!(request.tolerance >= 0 && request.tolerance <= 50)) {
    throw InputError(fmt::format("--tolerance {}: must be within 0..50 [%]", request.tolerance));
  }
  return {.limit = limit_of(request), .fastest = request.fastest};
}

void refuse_profile(const carrier_track::Scene& scene, const std::string& name) {
  if (scene.profile.empty()) return;
  throw InputError(name +
                   ": scene.omega is a profile: must be a number, because a threshold is of "
                   "constant speeds");
}

}  // namespace ricochet::cli
