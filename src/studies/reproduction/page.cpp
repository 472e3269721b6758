#include "src/studies/reproduction/page.h"

#include <fmt/format.h>

#include <cmath>

#include "src/studies/reproduction/sections.h"

namespace ricochet::studies::reproduction {

report::Page page_of(const Study& study) {
  const Agreement agreement = agreement_of(study.cases);
  report::Page page;
  page.title = "How fast may a braiding machine turn?";
  page.intro = {
      "A braiding machine carries its yarn on carriers that run along a track with a little "
      "clearance. Turn it too fast and the carriers hammer the track. Yao, Song, Pan and Lu (2024) "
      "report, for ten combinations of restitution, friction and disturbance, the speed from which "
      "the collisions multiply. This report computes those speeds anew, sets both side by side, "
      "and "
      "then uses the question to compare solvers: the count is an integer that jumps, and only a "
      "simulation gives it.",
      fmt::format(
          "Found: {} of the paper's 10 thresholds can be compared, and differ from it by "
          "{:.0f} % (root mean square of the logarithm of the ratio). Of the {} speeds that "
          "the paper's figures show as quiet or loud, {} come out on the paper's side.",
          agreement.thresholds, 100 * std::expm1(agreement.relative_error), agreement.examples,
          agreement.right),
      "How to read it: quiet means at most 1.5 times the usual count below the threshold, the "
      "quiet "
      "count. The threshold is the split of the speed range that puts the fewest speeds on the "
      "wrong side, quiet below and loud above. First loud is the lowest speed that is loud at all, "
      "which a machine should not exceed. Every figure here is computed; what the paper says is "
      "marked as the paper's."};
  page.sections = {threshold_section(study.cases), theory_section(study.cases),
                   curve_section(study.cases),     conclusion_section(study.grid, study.trends),
                   path_section(study.cases),      crossing_section(),
                   comparison_section(study),      contradiction_section(study),
                   provenance_section(study)};
  return page;
}

}  // namespace ricochet::studies::reproduction
