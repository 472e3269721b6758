#include "src/cli/quiet_speed_request.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "ricochet/error.h"
#include "ricochet/threshold.h"
#include "src/cli/limited.h"

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

void add_request(CLI::App* command, QuietSpeedRequest& asked) {
  add_seconds(command, asked.seconds);
  command->add_option("--fastest", asked.fastest, "End of the speed range [rad/s]")
      ->capture_default_str();
  command->add_option("--allow", asked.allow, "Limit: collisions in the window");
  command->add_option("--allow-per-turn", asked.allow_per_turn, "Limit: collisions per turn");
  command->add_option("--allow-energy", asked.allow_energy,
                      "Limit: energy [J] that the walls dissipate in the window");
  command->add_option("--allow-speed", asked.allow_speed,
                      "Limit: speed [m/s] of the fastest impact");
  command->add_option("--tolerance", asked.tolerance,
                      "Uncertainty of every constant [%]; prints the range of the answer");
}

carrier_track::QuietSpeedOptions options_of(const QuietSpeedRequest& request) {
  if (!(request.fastest >= carrier_track::shortest_range &&
        request.fastest <= carrier_track::longest_range)) {
    throw InputError(fmt::format("--fastest {}: must be within {}..{} [rad/s]", request.fastest,
                                 carrier_track::shortest_range, carrier_track::longest_range));
  }
  if (!(request.tolerance >= 0 && request.tolerance <= 50)) {
    throw InputError(fmt::format("--tolerance {}: must be within 0..50 [%]", request.tolerance));
  }
  return {.limit = limit_of(request), .fastest = request.fastest};
}

}  // namespace ricochet::cli
