#include <fmt/format.h>

#include "src/reproduction/path_chart.h"
#include "src/reproduction/sections.h"

namespace ricochet::reproduction {
namespace {

report::Figure path_of(const CaseStudy& c, double omega, const char* side,
                       const carrier_track::Recording& recording) {
  carrier_track::Scene scene = c.scene;
  scene.omega = omega;
  const int number = c.the_case.claim.figure->number;
  return {path_chart(scene, recording, fmt::format("path-{}-{}", number, side),
                     fmt::format("Figure {}, {} at {} rad/s: {} collisions", number, c.the_case.id,
                                 omega, recording.count)),
          recording.certainty.certain
              ? ""
              : fmt::format("The count is not certain: {}.", recording.certainty.reason)};
}

}  // namespace

report::Section path_section(const std::vector<CaseStudy>& cases) {
  report::Section section{"paths", "The carrier in its clearance (Figures 5-14)"};
  section.paragraphs = {
      "The position between the two walls at the speed that the paper shows as quiet, and at the "
      "one that it shows as loud. The paper does not give the length of its window; here it is a "
      "fixed number of turns of the driver plate."};
  for (const CaseStudy& c : cases) {
    if (!c.paths) continue;
    const carrier_track::Figure& figure = *c.the_case.claim.figure;
    section.figures.push_back(path_of(c, figure.quiet, "quiet", c.paths->quiet));
    section.figures.push_back(path_of(c, figure.loud, "loud", c.paths->loud));
  }
  return section;
}

}  // namespace ricochet::reproduction
