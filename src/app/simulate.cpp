#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/regimes/basins.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "problems/carrier_track/scene/scene_fields.h"
#include "ricochet/error.h"
#include "ricochet/machine.h"
#include "src/app/command_line.h"
#include "src/app/report.h"
#include "src/app/scene_choice.h"
#include "src/report/drawing.h"
#include "src/report/json.h"
#include "src/report/table.h"
#include "src/report/text.h"
#include "src/studies/machine/charts.h"

namespace ricochet::cli {
namespace {

using namespace carrier_track;
using report::Json;

struct SimulateOptions {
  SceneChoice scene;
  std::optional<double> omega;  ///< [rad/s], replaces the scene's
  std::string fidelity;         ///< replaces the scene's; empty: the scene's
  double smoothing = 0.25;      ///< smoothing parameter of the surrogate that is printed
  bool json = false;
  double seconds = 60;  ///< time limit
  std::string csv;      ///< file for the path; empty: none
  std::string plot;     ///< SVG file for the path; empty: none
};

Fidelity fidelity_named(const std::string& wanted) {
  for (const auto& [name, level] : fidelity_names()) {
    if (name == wanted) return level;
  }
  throw InputError(fmt::format("--fidelity {}: there is no such level", wanted));
}

std::string speed_of(const Scene& scene) {
  if (scene.profile.empty()) return fmt::format("{} rad/s", scene.omega);
  return "a speed profile of " + report::counted(scene.profile.size(), "knot");
}

Json json_of(const std::optional<Graze>& graze) {
  if (!graze) return {};
  return {{"time", graze->time}, {"wall", name_of(graze->wall)}, {"distance", graze->distance}};
}

Table table_of(std::span<const Impact> impacts) {
  return impact_table(impacts);
}

Table table_of(std::span<const Peak> peaks) {
  Table table{"peaks", {{"time", "time [s]", ".8f"}, {"position", "maximum [m]", ".6g"}}};
  for (const Peak& peak : peaks) table.add(peak.time, peak.position);
  return table;
}

/// Everything but the impacts and the maxima, whose lists are left empty.
Json frame_of(const Recording& recording) {
  return {{"count", recording.count},
          {"surrogate", recording.surrogate},
          {"certain", recording.certainty.certain},
          {"complete", recording.certainty.doubt != Doubt::unfinished},
          {"reached", recording.complete ? Json() : Json(recording.end.time)},
          {"margin", recording.certainty.margin},
          {"graze", json_of(recording.certainty.graze)},
          {"growth", recording.certainty.growth},
          {"doubt", recording.certainty.certain ? Json() : Json(recording.certainty.reason)},
          {"impacts", Json::array()},
          {"peaks", Json::array()},
          {"end",
           {{"time", recording.end.time},
            {"position", recording.end.position},
            {"velocity", recording.end.velocity}}},
          {"evaluations", recording.end.evaluations},
          {"fidelity", name_of(fidelity_names(), recording.fidelity)}};
}

/// Prints the elements of a list in batches: millions of them would not fit into memory as one
/// tree.
template <class Element>
void print_elements(std::span<const Element> list) {
  constexpr std::size_t batch = 1000;
  const char* separator = "\n    ";
  for (std::size_t i = 0; i < list.size(); i += batch) {
    for (const Json& row :
         json_rows_of(table_of(list.subspan(i, std::min(batch, list.size() - i))))) {
      fmt::print("{}{}", std::exchange(separator, ",\n    "), row.dump());
    }
  }
  if (!list.empty()) fmt::print("\n  ");
}

void print_json(const Recording& recording) {
  const std::string frame = frame_of(recording).dump(2);
  const auto impacts = frame.find("\"impacts\": [") + 12;
  const auto peaks = frame.find("\"peaks\": [") + 10;
  fmt::print("{}", frame.substr(0, impacts));
  print_elements(std::span(recording.impacts));
  fmt::print("{}", frame.substr(impacts, peaks - impacts));
  print_elements(std::span(recording.peaks));
  fmt::print("{}\n", frame.substr(peaks));
}

Table path_table(const Recording& recording) {
  Table table{"path", columns_named("time_s,position_m,velocity_m_per_s")};
  for (const Sample& s : recording.path) table.add(s.time, s.position, s.velocity);
  return table;
}

report::Plot plot_of(const ChosenScene& chosen, const Recording& recording) {
  std::vector<report::Chart> charts = {
      studies::path_chart(chosen.scene, recording, "path",
                          fmt::format("{} at {}: {}", chosen.name, speed_of(chosen.scene),
                                      report::counted(recording.count, "collision")))};
  if (const auto zoom = studies::zoom_chart(chosen.scene, recording)) charts.push_back(*zoom);
  for (report::Chart& chart : charts) {
    chart.width = 960;
    chart.height = 360;
  }
  return report::plot_of(charts);
}

/// Prints the impacts or the maxima, whichever the rule uses, up to a limit; those that count
/// first.
void print_features(const Scene& scene, const Recording& recording) {
  constexpr std::size_t shown = 40;
  const std::vector<Feature> features = features_of(scene, recording);
  Table table = scene.rule == CountRule::impacts ? table_of(std::span(recording.impacts))
                                                 : table_of(std::span(recording.peaks));
  std::size_t next = 0;
  table = sorted(with(table, {"counts", "", "mark"},
                      [&](const Row&) { return value_of(features[next++].counts); }),
                 {"-counts"});
  const std::size_t all = table.rows.size();
  table.rows.resize(std::min(all, shown));
  print_table(table, false);
  if (all > shown) fmt::print("... and {} more; --format json lists all\n", all - shown);
}

/// What the start causes; nothing if that is not known, or there is no time for it.
std::optional<Anatomy> anatomy_in_time(const Scene& scene, const Recording& recording) {
  try {
    if (recording.complete) return carrier_track::anatomy_of(scene, recording.impacts);
  } catch (const TimeLimitReached&) {
  }
  return std::nullopt;
}

void print(const ChosenScene& chosen, const Recording& recording,
           const std::optional<Anatomy>& anatomy) {
  const Certainty& certainty = recording.certainty;
  fmt::print("{} at {}: {} in {:.4g} s ({}; surrogate {:.4f})\n", chosen.name,
             speed_of(chosen.scene), report::counted(recording.count, "collision"),
             recording.end.time, certainty.certain ? "certain" : "not certain",
             recording.surrogate);
  if (chosen.scene.fidelity == Fidelity::automatic) {
    fmt::print("level of the model that it needs: {}\n",
               name_of(fidelity_names(), recording.fidelity));
  }
  if (!certainty.certain) fmt::print("not certain: {}\n", certainty.reason);
  if (certainty.margin) {
    fmt::print("nearest margin to zero: {:.3g}; a small change grows {:.2g}-fold\n",
               *certainty.margin, certainty.growth);
  }
  if (certainty.graze) {
    fmt::print("nearest missed wall: the {}, by {:.3g} m at {:.6g} s\n",
               name_of(certainty.graze->wall), certainty.graze->distance, certainty.graze->time);
  }
  if (anatomy) {
    fmt::print(
        "{} of the collisions are the start's and do not come again; {} are of the long run, "
        "which has {:.4g} a turn\n",
        anatomy->of_start, anatomy->of_long_run, anatomy->per_turn);
  }
  fmt::print("{}, slow ones included; {} of x; those that count come first\n",
             report::counted(recording.impacts.size(), "impact"),
             report::counted(recording.peaks.size(), "maximum", "maxima"));
  print_features(chosen.scene, recording);
}

int simulate(const SimulateOptions& options) {
  ChosenScene chosen = choose_scene(options.scene);
  if (options.omega) {
    chosen.scene = at_speed(chosen.scene, *options.omega);
    check_omega(chosen.scene, chosen.name, "--omega");
  }
  if (!options.fidelity.empty()) {
    chosen.scene.fidelity = fidelity_named(options.fidelity);
    check(chosen.scene, chosen.name);
  }
  if (!(options.smoothing > 0 && std::isfinite(options.smoothing))) {
    throw InputError(fmt::format("--smoothing {}: must be a finite number > 0", options.smoothing));
  }
  refuse_same_files({{"--csv", options.csv}, {"--plot", options.plot}}, {options.scene.scene_file});
  const bool path = !options.csv.empty() || !options.plot.empty();
  Recording recording;
  std::optional<Anatomy> anatomy;
  limited(options.seconds, [&] {
    recording = carrier_track::simulate(chosen.scene, options.smoothing, path ? 2000 : 0);
    if (!options.json) anatomy = anatomy_in_time(chosen.scene, recording);
  });
  report::Plot plot;
  if (!options.plot.empty()) plot = plot_of(chosen, recording);
  write_files({{options.csv, options.csv.empty() ? "" : csv_of(path_table(recording))},
               {options.plot, plot.svg}});
  if (options.json) {
    print_json(recording);
  } else {
    print(chosen, recording, anatomy);
  }
  report::require_none(plot.failures);
  if (recording.certainty.doubt != Doubt::unfinished) return 0;
  return report_incomplete(
      options.seconds, recording.complete ? "it is not known whether the count is certain"
                                          : fmt::format("everything is that of the first {:.6g} s",
                                                        recording.end.time));
}

}  // namespace

void add_simulate(CommandLine& line) {
  CLI::App* command =
      line.add("simulate", "Simulate one machine: impacts, peaks, count, certainty",
               "  ricochet simulate --case C1 --omega 5\n"
               "  ricochet simulate --scene machine.toml --plot path.svg --csv path.csv\n"
               "  ricochet simulate --scene machine.toml --set friction=0.3 --set 'omega=60 rpm'");
  const auto options = std::make_shared<SimulateOptions>();
  add_scene_choice(command, options->scene);
  add_format(command, options->json);
  add_seconds(command, options->seconds);
  command->add_option("--omega", options->omega, "Speed [rad/s] in place of the scene's");
  std::set<std::string> levels;
  for (const auto& [name, level] : fidelity_names()) levels.emplace(name);
  command
      ->add_option("--fidelity", options->fidelity, "Level of the model, in place of the scene's")
      ->check(CLI::IsMember(levels));
  add_value(command, "--smoothing", options->smoothing, "Smoothing parameter of the surrogate");
  add_value(command, "--csv", options->csv, "CSV file for the path: time, position, velocity",
            "FILE");
  add_value(command, "--plot", options->plot, "SVG file for a chart of the path", "FILE");
  line.on_call(command, [options] { return simulate(*options); });
}

}  // namespace ricochet::cli
