#include <fmt/format.h>

#include <numbers>

#include "src/studies/reproduction/path_chart.h"
#include "src/studies/reproduction/sections.h"

namespace ricochet::studies::reproduction {
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

/// Impacts that count, before and after the first tenth of a turn.
struct Halves {
  std::ptrdiff_t start, later;
};

Halves halves_of(const CaseStudy& c, double omega, const carrier_track::Recording& recording) {
  const double end_of_start = 0.1 * 2 * std::numbers::pi / omega;
  Halves halves{0, 0};
  for (const carrier_track::Impact& impact : recording.impacts) {
    if (impact.speed > c.scene.slowest) {
      ++(impact.time < end_of_start ? halves.start : halves.later);
    }
  }
  return halves;
}

std::string what_happens_in(const CaseStudy& c) {
  const carrier_track::Figure& figure = *c.the_case.claim.figure;
  const Halves quiet = halves_of(c, figure.quiet, c.paths->quiet);
  const Halves loud = halves_of(c, figure.loud, c.paths->loud);
  return fmt::format(
      "{} (restitution {}, friction {}) hits {} times in the first tenth of a turn and {} times "
      "later at {} rad/s, {} and {} times at {} rad/s.",
      c.the_case.id, c.the_case.restitution, c.the_case.friction, quiet.start, quiet.later,
      figure.quiet, loud.start, loud.later, figure.loud);
}

}  // namespace

report::Section path_section(const std::vector<CaseStudy>& cases) {
  report::Section section{"paths", "The carrier in its clearance (Figures 5-14)"};
  section.paragraphs = {
      "The position between the two walls at the speed that the paper shows as quiet, and at the "
      "one that it shows as loud. The paper does not give the length of its window; here it is a "
      "fixed number of turns of the driver plate.",
      "What the carrier does, and why: its start throws it against a wall, and as long as the "
      "plate "
      "turns slowly it hits the walls as often as restitution and friction let it, whatever the "
      "plate's speed. After that it rests on a wall until the centrifugal force, which turns over "
      "twice a turn, beats friction and throws it across: one impact, whose speed grows with the "
      "plate's, and after it rebounds, which count only as long as they are faster than the "
      "slowest "
      "impact that counts. So there is a plateau, and a speed at which a further rebound of each "
      "throw begins to count. With restitution 0.1 a wall must be hit ten times as fast for that "
      "as "
      "the slowest impact that counts; with 0.9 rebounds count as soon as there are throws at all. "
      "A disturbance of 1 N hardly matters beside a centrifugal force of some tens of newtons."};
  for (const CaseStudy& c : cases) {
    const auto& id = c.the_case.id;
    if (c.paths && (id == "C1" || id == "C2" || id == "C4")) {
      section.paragraphs.push_back(what_happens_in(c));
    }
  }
  for (const CaseStudy& c : cases) {
    if (!c.paths) continue;
    const carrier_track::Figure& figure = *c.the_case.claim.figure;
    section.figures.push_back(path_of(c, figure.quiet, "quiet", c.paths->quiet));
    section.figures.push_back(path_of(c, figure.loud, "loud", c.paths->loud));
  }
  return section;
}

}  // namespace ricochet::studies::reproduction
