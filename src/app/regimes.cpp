#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <optional>
#include <string>

#include "problems/carrier_track/regimes/followed_motion.h"
#include "problems/carrier_track/regimes/regime_map.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/scene_file.h"
#include "ricochet/error.h"
#include "ricochet/machine.h"
#include "src/analysis/statistics/intervals.h"
#include "src/app/command_line.h"
#include "src/app/report.h"
#include "src/app/scene_choice.h"
#include "src/core/files.h"
#include "src/report/drawing.h"
#include "src/report/json.h"
#include "src/report/text.h"
#include "src/studies/machine/charts.h"
#include "src/studies/machine/regime_tables.h"

namespace ricochet::cli {

struct RegimesOptions {
  SceneChoice scene;
  carrier_track::RegimeOptions range;
  bool json = false;
  double seconds = 60;  ///< time limit
  std::string plot;     ///< SVG file for a chart; empty: none

  std::string over;           ///< CONSTANT=FROM..TO: borders over it; empty: none
  std::optional<int> values;  ///< of that constant
  std::string csv;            ///< CSV file for the points of the borders; empty: none

  std::optional<int> starts;    ///< to sample at one speed
  std::optional<double> omega;  ///< [rad/s], that speed; if missing: the scene's
  carrier_track::BasinOptions sampled = {};
};

/// Prints the borders of a machine over a constant, and draws the map of its regimes. Returns the
/// exit code.
int regime_curves(const RegimesOptions& options);

/// Prints which motions sampled starts of a machine lead to, at one speed. Returns the exit code.
int basins(const RegimesOptions& options);

namespace {

using carrier_track::RegimeEnd;

int regimes(const RegimesOptions& options) {
  if (!options.over.empty()) return regime_curves(options);
  if (options.starts) return basins(options);
  const ChosenScene chosen = choose_scene(options.scene);
  refuse_same_file("--plot", options.plot, options.scene.scene_file, "the scene");
  const auto found = limited(
      options.seconds,
      [&]() -> std::vector<carrier_track::Regime> {
        try {
          return carrier_track::regimes_of(chosen.scene, options.range);
        } catch (const TimeLimitReached&) {
          return {};  // not even the first one is known
        }
      },
      seconds_to_sample(options.seconds));
  const double reached = found.empty() ? options.range.from : found.back().to;
  const bool complete = !found.empty() && found.back().ends_by != RegimeEnd::time_limit;
  report::Plot plot;
  if (!options.plot.empty() && !found.empty()) {
    carrier_track::QuietSpeed drawn;
    drawn.options.fastest = options.range.to;
    drawn.regimes = found;
    plot = report::plot_of({studies::advice::staircase_chart(
        drawn, chosen.name + ": collisions a turn in the long run", {})});
  }
  if (!plot.svg.empty()) write_text_file(options.plot, plot.svg);
  if (options.json) {
    fmt::print("{}\n", studies::advice::json_of(found).dump(2));
  } else {
    if (!found.empty()) {
      fmt::print("{}: {}.\n{}", chosen.name, studies::advice::summary_of(found),
                 studies::advice::text_of(found, std::nullopt));
    }
    if (!complete) {
      fmt::print("{}",
                 studies::advice::text_of(sampled_in_time(chosen.scene, reached, options.range.to,
                                                          seconds_to_sample(options.seconds))));
    }
  }
  report::require_none(plot.failures);
  if (complete) return 0;
  return report_incomplete(options.seconds, fmt::format("nothing is known from {:.6g} to {} rad/s",
                                                        reached, options.range.to));
}

}  // namespace

void add_regimes(CommandLine& line) {
  CLI::App* command =
      line.add("regimes", "Show what the carrier does in the long run, over the speed",
               "  ricochet regimes --case C1\n"
               "  ricochet regimes --scene machine.toml --to 10 --plot regimes.svg\n"
               "  ricochet regimes --case C1 --over restitution=0.05..0.95 --plot map.svg\n"
               "  ricochet regimes --scene machine.toml --over 'clearance=0.5..2 mm'\n"
               "  ricochet regimes --case C2 --omega 12 --starts 1000");
  const auto options = std::make_shared<RegimesOptions>();
  add_scene_choice(command, options->scene);
  add_format(command, options->json);
  add_seconds(command, options->seconds);
  command->add_option("--from", options->range.from, "Start of the speed range [rad/s]")
      ->capture_default_str();
  command->add_option("--to", options->range.to, "End of the speed range [rad/s]")
      ->capture_default_str();
  command
      ->add_option("--plot", options->plot,
                   "SVG file for a chart of the collisions a turn; with --over: for a map")
      ->type_name("FILE");
  CLI::Option* over =
      command
          ->add_option(
              "--over", options->over,
              "Follow every border over a constant: " +
                  fmt::format("{}", fmt::join(carrier_track::continuation_constants(), ", ")))
          ->type_name("CONSTANT=FROM..TO");
  command
      ->add_option(
          "--values", options->values,
          fmt::format("Values of that constant to solve the regimes at; default: {}, or {} "
                      "under a disturbance, where each takes up to some seconds",
                      carrier_track::usual_values, carrier_track::few_values))
      ->needs(over);
  command->add_option("--csv", options->csv, "CSV file for the points of the borders, in SI units")
      ->type_name("FILE")
      ->needs(over);
  CLI::Option* starts =
      command
          ->add_option("--starts", options->starts,
                       "Sample so many starts at one speed: which motions do they lead to?")
          ->excludes(over);
  command->add_option("--omega", options->omega, "That speed [rad/s], in place of the scene's")
      ->needs(starts);
  command->add_option("--seed", options->sampled.seed, "Seed of the random starts")
      ->capture_default_str()
      ->needs(starts);
  command
      ->add_option("--height", options->sampled.height,
                   "Highest start [m] above the lower wall; default: the clearance")
      ->needs(starts);
  command
      ->add_option("--start-speed", options->sampled.fastest,
                   "Fastest start [m/s]; default: from the machine")
      ->needs(starts);
  line.on_call(command, [options] { return regimes(*options); });
}

namespace {

using namespace carrier_track;
using namespace studies::advice;

/// "normal force" for normal_force.
std::string words_for(std::string constant) {
  std::ranges::replace(constant, '_', ' ');
  return constant;
}

/// Whether two machines are equal but for that constant.
bool differ_in_one(const std::string& constant, const Scene& a, Scene b) {
  if (constant == "restitution" && b.restitution_lower != b.restitution_upper) return false;
  set_constant(b, constant, constant_named(a, constant));
  return write_scene(a) == write_scene(b);
}

/// The machine, and the paper's thresholds of all cases that are on its map.
MapMarks marks_of(const ChosenScene& chosen, const RegimeMap& map, const ShownUnit& unit) {
  const std::string& constant = map.options.constant;
  MapMarks marks;
  const auto is_on_map = [&](double value) {
    return map.options.from <= value && value <= map.options.to;
  };
  if (is_on_map(map.own)) {
    marks.machines.push_back(
        {map.own, fmt::format("{}: {} {:.4g}{}{}", chosen.name, words_for(constant),
                              map.own / unit.size, unit.name.empty() ? "" : " ", unit.name)});
  }
  for (const ChosenScene& other : every_case()) {
    const double value = constant_named(other.scene, constant);
    if (!other.claim.threshold || !is_on_map(value)) continue;
    if (!differ_in_one(constant, chosen.scene, other.scene)) continue;
    marks.thresholds.push_back({value, *other.claim.threshold,
                                fmt::format("{}: {:.4g}", other.name, *other.claim.threshold)});
  }
  return marks;
}

report::Plot plot_of(const ChosenScene& chosen, const RegimeMap& map, const ShownUnit& unit) {
  const std::string title =
      fmt::format("Collisions a turn in the long run: {} with other values of the {}", chosen.name,
                  words_for(map.options.constant));
  return report::plot_of({regime_map_chart(map, title, unit, marks_of(chosen, map, unit))});
}

}  // namespace

int regime_curves(const RegimesOptions& options) {
  const ChosenScene chosen = choose_scene(options.scene);
  refuse_same_file("--csv", options.csv, options.scene.scene_file, "the scene");
  refuse_same_file("--plot", options.plot, options.scene.scene_file, "the scene");
  refuse_same_file("--plot", options.plot, options.csv, "that of --csv");
  const ConstantRange range = constant_range_of(options.over);
  const RegimeMap map = limited(options.seconds, [&] {
    return regime_map(chosen.scene,
                      {range.constant, range.from, range.to, options.values, options.range});
  });
  std::deque<TextDraft> drafts;
  if (!options.csv.empty()) drafts.emplace_back(options.csv, csv_of(map));
  report::Plot plot;
  if (!options.plot.empty()) plot = plot_of(chosen, map, range.unit);
  if (!plot.svg.empty()) drafts.emplace_back(options.plot, plot.svg);
  for (TextDraft& draft : drafts) draft.commit();
  if (options.json) {
    report::Json json = {{"machine", chosen.name}};
    json.update(json_of(map));
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("{}: borders between regimes over {}; the machine itself has {:.4g}{}{}.\n{}",
               chosen.name, range.constant, map.own / range.unit.size,
               range.unit.name.empty() ? "" : " ", range.unit.name, text_of(map, range.unit));
  }
  report::require_none(plot.failures);
  return 0;
}

namespace {

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
      "{} at {:.4g} rad/s: {} starts lead to {}.\n"
      "Starts are uniform: up to {:.4g} mm above the lower wall, velocity up to {:.4g} mm/s either "
      "way, any phase; seed {}.\n",
      name, omega, found.starts, report::counted(found.basins.size(), "motion"), 1e3 * found.height,
      1e3 * found.fastest, options.sampled.seed);
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
