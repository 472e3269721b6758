#include <fmt/format.h>

#include <algorithm>

#include "src/report/text.h"
#include "src/studies/reproduction/sections.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;
using report::lower_case;

/// The staircase, with a sample only where it jumps.
std::vector<report::Sample> samples_of(const SpeedScan& scan) {
  std::vector<report::Sample> samples;
  for (std::size_t k = 0; k < scan.counts.size(); ++k) {
    const bool last = k + 1 == scan.counts.size();
    if (k > 0 && !last && scan.counts[k] == scan.counts[k - 1]) continue;
    samples.push_back({scan.omega(k), scan.counts[k]});
  }
  return samples;
}

report::Figure curve_of(const CaseStudy& c) {
  const Case& the_case = c.the_case;
  const SpeedScan shown = c.scan.step < 0.01 ? thinned(c.scan, 10) : c.scan;
  report::Chart chart;
  chart.name = fmt::format("count-{}", lower_case(the_case.id));
  chart.title = fmt::format("{}: restitution {}, friction {}, disturbance {} N", the_case.id,
                            the_case.restitution, the_case.friction, the_case.disturbance);
  chart.x = {"speed [rad/s]", report::Scale::linear, report::Range{0, 18}};
  const int most = *std::max_element(shown.counts.begin(), shown.counts.end());
  chart.y = {"collisions", report::Scale::linear, report::Range{0, 1.1 * most}};
  chart.series = {{"", report::Mark::steps, samples_of(shown)}};
  using report::Direction;
  // In this order, so that each line looks the same in every chart.
  chart.lines = {{Direction::horizontal, quiet_limit(c.score.quiet_count), "quiet up to here"}};
  if (c.score.threshold) {
    chart.lines.push_back({Direction::vertical, *c.score.threshold, "threshold"});
  }
  if (the_case.claim.threshold) {
    chart.lines.push_back({Direction::vertical, *the_case.claim.threshold, "paper's threshold"});
  }
  return {chart, ""};
}

}  // namespace

report::Section curve_section(const std::vector<CaseStudy>& cases) {
  report::Section section{"counts", "Collisions against speed"};
  section.paragraphs = {
      "The objective as a solver meets it: a whole number that jumps, up and down, and is flat in "
      "between, so that its derivative is zero or does not exist."};
  for (const CaseStudy& c : cases) section.figures.push_back(curve_of(c));
  return section;
}

}  // namespace ricochet::studies::reproduction
