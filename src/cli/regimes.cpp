#include "src/cli/regimes.h"

#include <fmt/format.h>

#include "problems/carrier_track/advice/regime_table.h"
#include "problems/carrier_track/advice/staircase_chart.h"
#include "problems/carrier_track/regimes/orbit_map.h"
#include "problems/carrier_track/regimes/regime_map.h"
#include "src/cli/basins.h"
#include "src/cli/commands.h"
#include "src/cli/limited.h"
#include "src/cli/output_files.h"
#include "src/cli/regime_curves.h"
#include "src/cli/shared_options.h"
#include "src/core/text_file.h"
#include "src/report/drawn_chart.h"
#include "src/report/json.h"

namespace ricochet::cli {
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

}  // namespace ricochet::cli
