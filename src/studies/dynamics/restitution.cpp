#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "problems/carrier_track/motion/simulate.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "src/studies/dynamics/work.h"

namespace ricochet::studies::dynamics {

using namespace carrier_track;

using report::Chart;
using report::Mark;
using report::Series;

namespace {

double distance(const ReturnedRestitution& point) {
  return std::abs(point.returned - point.asked);
}

constexpr double faithful_within = 0.01;

}  // namespace

ReturnedRestitution worst_of(const LawStudy& study) {
  return *std::max_element(study.exact.begin(), study.exact.end(),
                           [](const auto& a, const auto& b) { return distance(a) < distance(b); });
}

double largest_measurement_error(const LawStudy& study) {
  double largest = 0;
  for (const ReturnedRestitution& point : study.measured) {
    largest = std::max(largest, std::abs(point.returned - closed_return(study.law, point.asked)));
  }
  return largest;
}

double closed_return(ContactLaw law, double asked) {
  if (law != ContactLaw::kelvin_voigt) return returned_restitution(dissipation(law, asked));
  return kelvin_voigt_restitution(damping_ratio(asked, Release::zero_force), Release::zero_force);
}

double measured_return(ContactLaw law, double asked) {
  Scene scene;  // 1 kg without any force, 1 mm above the only wall
  scene.wall_upper = std::numeric_limits<double>::infinity();
  scene.restitution_lower = scene.restitution_upper = asked;
  scene.start_position = 1e-3;
  scene.start_velocity = -1;
  scene.window = Seconds{1};
  scene.fidelity = Fidelity::compliant;
  scene.contact_law = law;
  if (law == ContactLaw::kelvin_voigt) scene.contact_exponent = 1;
  Observer nobody;
  return simulate(scene, nobody).velocity / -scene.start_velocity;
}

std::vector<LawStudy> study_laws(std::size_t stride) {
  std::vector<LawStudy> studies;
  for (const auto& [name, law] : contact_law_names()) {
    LawStudy& study = studies.emplace_back(LawStudy{std::string(name), law, {}, {}});
    for (std::size_t k = 2; k <= 98; ++k) {
      const double asked = 0.01 * static_cast<double>(k);
      study.exact.push_back({asked, closed_return(law, asked)});
      if ((k - 2) % stride == 0) study.measured.push_back({asked, measured_return(law, asked)});
    }
  }
  return studies;
}

void add_to(report::Results& results, const std::vector<LawStudy>& laws) {
  const double asked = 0.1;
  const double returned = closed_return(ContactLaw::hunt_crossley, asked);
  Table table{"restitution",
              {{"law", "contact law"},
               {"of_a_tenth", "asked for 0.1, returns", ".3f"},
               {"of_nine_tenths", "asked for 0.9, returns", ".3f"},
               {"off", "off by at most", ".3f"},
               {"worst_asked", "asked there for", ".2f"},
               {"measurement_error", "simulated, off the relation by", ".0e"}}};
  Chart chart{
      .name = "restitution",
      .title = fmt::format("Asked for {}, Hunt-Crossley's law returns {:.2f}", asked, returned),
      .x = {.label = "restitution asked for", .range = report::Range{0, 1}},
      .y = {.label = "restitution returned", .range = report::Range{0, 1.02}},
      .series = {{"as asked for", Mark::line, {{0, 0}, {1, 1}}}},
      .width = 780,
      .height = 460};
  Series measured{"simulated impacts, every law", Mark::points, {}};
  std::vector<std::string> faithful;
  for (const LawStudy& law : laws) {
    const ReturnedRestitution worst = worst_of(law);
    const double off = distance(worst);
    if (off <= faithful_within) faithful.push_back(law.name);
    const bool exact = off < 5e-4;  // its worst place depends on rounding only
    table.add(law.name, closed_return(law.law, 0.1), closed_return(law.law, 0.9), off,
              exact ? std::nullopt : std::optional(worst.asked), largest_measurement_error(law));
    Series& series = chart.series.emplace_back(Series{law.name, Mark::line, {}});
    for (const auto& point : law.exact) series.samples.push_back({point.asked, point.returned});
    for (const auto& point : law.measured) {
      measured.samples.push_back({point.asked, point.returned});
    }
  }
  chart.series.push_back(std::move(measured));
  results.set("laws-finding",
              fmt::format("Asked for a restitution of {}, Hunt-Crossley's law returns {:.3f}.",
                          asked, returned));
  results.set("energy-asked", asked * asked);
  results.set("energy-returned", returned * returned);
  results.set("faithful", faithful.empty() ? "none" : fmt::format("{}", fmt::join(faithful, ", ")));
  results.add(std::move(table));
  results.add(std::move(chart));
}

}  // namespace ricochet::studies::dynamics
