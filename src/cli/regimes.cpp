#include "src/cli/regimes.h"

#include <fmt/format.h>

#include "problems/carrier_track/advice/regime_table.h"
#include "problems/carrier_track/advice/staircase_chart.h"
#include "src/cli/basins.h"
#include "src/cli/output_files.h"
#include "src/cli/regime_curves.h"
#include "src/core/text_file.h"
#include "src/report/drawn_chart.h"
#include "src/report/json.h"

namespace ricochet::cli {

int regimes(const RegimesOptions& options) {
  if (!options.over.empty()) return regime_curves(options);
  if (options.starts) return basins(options);
  const ChosenScene chosen = choose_scene(options.scene);
  refuse_same_file("--plot", options.plot, options.scene.scene_file, "the scene");
  const auto found = carrier_track::regimes_of(chosen.scene, options.range);
  report::Plot plot;
  if (!options.plot.empty()) {
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
    fmt::print("{}: {}.\n{}", chosen.name, studies::advice::summary_of(found),
               studies::advice::text_of(found, std::nullopt));
  }
  report::require_none(plot.failures);
  return 0;
}

}  // namespace ricochet::cli
