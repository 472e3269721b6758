#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "problems/carrier_track/regimes/followed_motion.h"
#include "problems/carrier_track/regimes/regime_map.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/scene_fields.h"
#include "problems/carrier_track/scene/scene_file.h"
#include "ricochet/error.h"
#include "ricochet/machine.h"
#include "src/analysis/statistics/intervals.h"
#include "src/app/command_line.h"
#include "src/app/report.h"
#include "src/app/scene_choice.h"
#include "src/core/names.h"
#include "src/report/drawing.h"
#include "src/report/json.h"
#include "src/report/table.h"
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

  std::string over;     ///< CONSTANT=FROM..TO: a map over it; empty: none
  std::string against;  ///< CONSTANT=FROM..TO in place of the speed
  int values = carrier_track::usual_values;
  std::string csv;  ///< CSV file for the points of the borders; empty: none

  std::optional<int> starts;    ///< to sample at one speed
  std::optional<double> omega;  ///< [rad/s], that speed; if missing: the scene's
  carrier_track::BasinOptions sampled = {};
};

/// A range of a constant of a scene: "restitution=0.05..0.95", "clearance=0.5 mm..2 mm",
/// "clearance=0.5..2 mm".
struct ConstantRange {
  carrier_track::MapAxis axis;        ///< in SI units
  studies::advice::ShownUnit unit{};  ///< of the range's end
};

/// Throws InputError, which names the option, for a text that is no such range or has an unknown
/// constant or unit.
ConstantRange constant_range_of(const std::string& option, const std::string& text);

/// Prints the borders of a machine over a constant, and draws the map of its regimes. Returns the
/// exit code.
int regime_curves(const RegimesOptions& options);

/// Prints which motions sampled starts of a machine lead to, at one speed. Returns the exit code.
int basins(const RegimesOptions& options);

namespace {

using namespace carrier_track;
using namespace studies::advice;

int regimes(const RegimesOptions& options) {
  if (!options.over.empty()) return regime_curves(options);
  if (options.starts) return basins(options);
  const ChosenScene chosen = choose_scene(options.scene);
  refuse_same_files({{"--plot", options.plot}}, {options.scene.scene_file});
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
    plot = report::plot_of(
        {staircase_chart(drawn, chosen.name + ": collisions a turn in the long run", {})});
  }
  write_files({{options.plot, plot.svg}});
  if (options.json) {
    print_table(regime_table(found), true);
  } else {
    if (!found.empty()) {
      fmt::print("{}: {}.\n", chosen.name, summary_of(found));
      print_table(shown_regimes(found), false);
    }
    if (!complete) {
      fmt::print("{}", text_of(sampled_in_time(chosen.scene, reached, options.range.to,
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
  add_value(command, "--from", options->range.from, "Start of the speed range [rad/s]");
  add_value(command, "--to", options->range.to, "End of the speed range [rad/s]");
  add_value(command, "--plot", options->plot,
            "SVG file for a chart of the collisions a turn; with --over: for a map", "FILE");
  CLI::Option* over =
      add_value(command, "--over", options->over,
                "Follow every border over a constant: " +
                    fmt::format("{}", fmt::join(carrier_track::continuation_constants(), ", ")),
                "CONSTANT=FROM..TO");
  add_value(command, "--against", options->against,
            "A second constant in place of the speed, which is then the scene's",
            "CONSTANT=FROM..TO")
      ->needs(over);
  add_value(command, "--values", options->values, "Values of the first constant")->needs(over);
  add_value(command, "--csv", options->csv, "CSV file for the points of the borders, in SI units",
            "FILE")
      ->needs(over);
  CLI::Option* starts =
      command
          ->add_option("--starts", options->starts,
                       "Sample so many starts at one speed: which motions do they lead to?")
          ->excludes(over);
  command->add_option("--omega", options->omega, "That speed [rad/s], in place of the scene's")
      ->needs(starts);
  add_value(command, "--seed", options->sampled.seed, "Seed of the random starts")->needs(starts);
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
  const auto& [constant, from, to] = map.options.over;
  MapMarks marks;
  const auto is_on_map = [from = from, to = to](double value) {
    return from <= value && value <= to;
  };
  if (is_on_map(map.own)) {
    marks.machines.push_back(
        {map.own, fmt::format("{}: {} {:.4g}{}{}", chosen.name, words_for(constant),
                              map.own / unit.size, unit.name.empty() ? "" : " ", unit.name)});
  }
  for (const ChosenScene& other : every_case()) {
    const double value = constant_named(other.scene, constant);
    if (!other.claim.threshold || !is_on_map(value) || map.options.against.key != "omega") continue;
    if (!differ_in_one(constant, chosen.scene, other.scene)) continue;
    marks.thresholds.push_back({value, *other.claim.threshold,
                                fmt::format("{}: {:.4g}", other.name, *other.claim.threshold)});
  }
  return marks;
}

}  // namespace

int regime_curves(const RegimesOptions& options) {
  const ChosenScene chosen = choose_scene(options.scene);
  refuse_same_files({{"--csv", options.csv}, {"--plot", options.plot}}, {options.scene.scene_file});
  const ConstantRange over = constant_range_of("--over", options.over);
  ConstantRange against{{"omega", options.range.from, options.range.to}, {"rad/s"}};
  if (!options.against.empty()) against = constant_range_of("--against", options.against);
  const MapUnits units{over.unit, against.unit};
  const RegimeMap map = limited(options.seconds, [&] {
    return regime_map(chosen.scene, {over.axis, options.values, against.axis});
  });
  report::Plot plot;
  if (!options.plot.empty()) {
    const std::string title =
        fmt::format("Collisions a turn in the long run: {} with other values of the {}{}",
                    chosen.name, words_for(over.axis.key),
                    options.against.empty() ? "" : " and the " + words_for(against.axis.key));
    plot = report::plot_of({regime_map_chart(map, title, units, marks_of(chosen, map, over.unit))});
  }
  write_files({{options.csv, csv_of(point_table(map))}, {options.plot, plot.svg}});
  if (options.json) {
    report::Json json = {{"machine", chosen.name}};
    json.update(json_of(map));
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("{}: borders between regimes over {}; the machine itself has {:.4g}{}{}.\n{}",
               chosen.name, over.axis.key, map.own / over.unit.size,
               over.unit.name.empty() ? "" : " ", over.unit.name, text_of(map, units));
  }
  report::require_none(plot.failures);
  if (map.complete) return 0;
  return report_incomplete(options.seconds, "the map has the cells that had time");
}

namespace {

Table basin_table(const Basins& found) {
  Table table{"motions",
              {{"starts"},
               {"share", "share [%]", ".1%"},
               {"share_lower", "95 % from [%]", ".1%"},
               {"share_upper", "to [%]", ".1%"},
               {"collisions_per_turn", "collisions a turn"},
               {"turns", "period [turns; 0: none]"},
               {"energy_per_turn", "energy a turn [mJ]", ".4gm"},
               {"fastest_impact", "fastest impact [mm/s]", ".4gm"},
               {"share_at_rest", "at rest [%]", ".0%"}}};
  for (const auto& [motion, turns, starts] : found.basins) {
    const Interval share = wilson_interval(starts, found.starts);
    table.add(starts, static_cast<double>(starts) / found.starts, share.lower, share.upper,
              motion.collisions_per_turn, turns, motion.energy_per_turn, motion.fastest_impact,
              motion.share_at_rest);
  }
  return table;
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
    const report::Json json = {
        {"omega", chosen.scene.omega},    {"starts", found.starts},
        {"seed", sampled.seed},           {"height", found.height},
        {"fastest_start", found.fastest}, {"motions", json_rows_of(basin_table(found))}};
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print(
        "{} at {:.4g} rad/s: {} starts lead to {}.\n"
        "Starts are uniform: up to {:.4g} mm above the lower wall, velocity up to {:.4g} mm/s "
        "either way, any phase; seed {}.\n",
        chosen.name, chosen.scene.omega, found.starts,
        report::counted(static_cast<std::int64_t>(found.basins.size()), "motion"),
        1e3 * found.height, 1e3 * found.fastest, sampled.seed);
    print_table(basin_table(found), false);
  }
  if (found.starts == *options.starts) return 0;
  return report_incomplete(
      options.seconds, fmt::format("{} of {} starts were sampled", found.starts, *options.starts));
}

namespace {

/// The SI unit of a constant, "1" for a number without unit.
std::string unit_of(const std::string& constant) {
  if (constant == "clearance") return "m";
  std::string unit = "1";
  Scene scene;
  const auto visit = [&](const SceneField& field, const auto&... /*members*/) {
    if (field.key == constant) unit = field.unit;
  };
  visit_scene_fields(visit, scene);
  visit_count_fields(visit, scene);
  return unit;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

/// The name of the unit that a text ends with; empty if it is a plain number.
std::string unit_in(std::string_view text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc()) return "";
  return std::string(trimmed(text.substr(static_cast<std::size_t>(end - text.data()))));
}

std::optional<double> number_of(std::string_view text, const std::string& unit,
                                const std::string& usual) {
  if (const auto number = number_of_text<double>(text)) {
    return usual.empty() ? number : quantity(fmt::format("{} {}", text, usual), unit);
  }
  return quantity(text, unit);
}

}  // namespace

ConstantRange constant_range_of(const std::string& option, const std::string& text) {
  const std::string origin = one_line(fmt::format("{} {}", option, text));
  const std::size_t equal = text.find('='), dots = text.find("..");
  if (equal == std::string::npos || dots == std::string::npos || dots < equal) {
    throw InputError(origin + ": must be CONSTANT=FROM..TO, as in restitution=0.05..0.95");
  }
  ConstantRange range{{std::string(trimmed(std::string_view(text).substr(0, equal))), 0, 0}, {}};
  auto& [key, lower_end, upper_end] = range.axis;
  try {
    constant_named(Scene{}, key);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{} {}", option, one_line(error.what())));
  }
  const std::string unit = unit_of(key);
  const std::string_view all = text;
  const std::string_view from = trimmed(all.substr(equal + 1, dots - equal - 1));
  const std::string_view to = trimmed(all.substr(dots + 2));
  const std::string name = unit_in(to);
  const auto lower = number_of(from, unit, name), upper = number_of(to, unit, name);
  if (!lower || !upper) {
    throw InputError(fmt::format(
        "{}: must be two numbers{}", origin,
        unit == "1" ? ""
                    : fmt::format(", with one of the units {}", fmt::join(units_for(unit), ", "))));
  }
  lower_end = *lower;
  upper_end = *upper;
  if (unit != "1") range.unit = {name.empty() ? unit : name, 1};
  if (!name.empty()) range.unit.size = *quantity("1 " + name, unit);
  return range;
}

}  // namespace ricochet::cli
