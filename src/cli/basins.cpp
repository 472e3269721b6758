#include "src/cli/basins.h"

#include <fmt/format.h>

#include "problems/carrier_track/scene/scene_check.h"
#include "ricochet/error.h"
#include "src/benchmark/statistics/wilson_interval.h"
#include "src/cli/limited.h"
#include "src/report/json.h"

namespace ricochet::cli {
namespace {

using namespace carrier_track;

std::string line_of(const Basin& basin, int starts) {
  const Interval share = wilson_interval(basin.starts, starts);
  const LongRun& motion = basin.motion;
  const std::string turns = basin.turns == 0 ? "irregular" : fmt::format("{}", basin.turns);
  return fmt::format(
      "{:>7}{:>9.1f} %{:>9.1f} to {:>5.1f} %{:>12.4g}{:>11}{:>12.4g}{:>10.4g}{:>6.0f} %\n",
      basin.starts, 100.0 * basin.starts / starts, 100 * share.lower, 100 * share.upper,
      motion.collisions_per_turn, turns, 1e3 * motion.energy_per_turn, 1e3 * motion.fastest_impact,
      100 * motion.share_at_rest);
}

void print(const std::string& name, double omega, const Basins& found,
           const RegimesOptions& options) {
  fmt::print(
      "{} at {:.4g} rad/s: {} starts lead to {} motion{}.\n"
      "Starts are uniform: up to {:.4g} mm above the lower wall, velocity up to {:.4g} mm/s either "
      "way, any phase; seed {}.\n",
      name, omega, found.starts, found.basins.size(), found.basins.size() == 1 ? "" : "s",
      1e3 * found.height, 1e3 * found.fastest, options.sampled.seed);
  fmt::print("{:>7}{:>11}{:>20}{:>12}{:>11}{:>12}{:>10}{:>8}\n", "starts", "share", "95 % interval",
             "collisions", "period", "energy", "fastest", "rest");
  fmt::print("{:>7}{:>11}{:>20}{:>12}{:>11}{:>12}{:>10}{:>8}\n", "", "", "", "a turn", "turns",
             "mJ a turn", "mm/s", "");
  for (const Basin& basin : found.basins) fmt::print("{}", line_of(basin, found.starts));
}

report::Json json_of(const Basins& found, double omega, const RegimesOptions& options) {
  return {{"omega", omega},
          {"starts", found.starts},
          {"seed", options.sampled.seed},
          {"height", found.height},
          {"fastest_start", found.fastest},
          {"motions", report::list_of(found.basins, [&](const Basin& basin) {
             const Interval share = wilson_interval(basin.starts, found.starts);
             return report::Json{{"starts", basin.starts},
                                 {"share", static_cast<double>(basin.starts) / found.starts},
                                 {"share_lower", share.lower},
                                 {"share_upper", share.upper},
                                 {"collisions_per_turn", basin.motion.collisions_per_turn},
                                 {"turns", basin.turns},
                                 {"energy_per_turn", basin.motion.energy_per_turn},
                                 {"fastest_impact", basin.motion.fastest_impact},
                                 {"share_at_rest", basin.motion.share_at_rest}};
           })}};
}

}  // namespace

int basins(const RegimesOptions& options) {
  if (!options.plot.empty()) throw InputError("--starts has no picture: it takes no --plot");
  ChosenScene chosen = choose_scene(options.scene);
  if (options.omega) {
    chosen.scene = at_speed(chosen.scene, *options.omega);
    check_omega(chosen.scene, chosen.name, "--omega");
  }
  BasinOptions sampled = options.sampled;
  sampled.starts = *options.starts;
  const Basins found = limited(options.seconds, [&] { return basins_of(chosen.scene, sampled); });
  if (options.json) {
    fmt::print("{}\n", json_of(found, chosen.scene.omega, options).dump(2));
  } else {
    print(chosen.name, chosen.scene.omega, found, options);
  }
  if (found.starts == *options.starts) return 0;
  return report_incomplete(
      options.seconds, fmt::format("{} of {} starts were sampled", found.starts, *options.starts));
}

}  // namespace ricochet::cli
