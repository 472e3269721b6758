#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "problems/carrier_track/motion/simulate.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "src/studies/simulators/suite.h"

/// The restitution that a contact law returns, against the one its damping was computed from.
namespace ricochet::studies::simulators {

using namespace carrier_track;

double closed_return(ContactLaw law, double asked) {
  if (law != ContactLaw::kelvin_voigt) return returned_restitution(dissipation(law, asked));
  return kelvin_voigt_restitution(damping_ratio(asked, Release::zero_force), Release::zero_force);
}

double simulated_return(ContactLaw law, double asked) {
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

void add_laws(report::Results& results, std::size_t stride) {
  constexpr double asked_for = 0.1;
  constexpr double faithful_within = 0.01;
  const double returned = closed_return(ContactLaw::hunt_crossley, asked_for);
  Table table{"restitution",
              {{"law", "contact law"},
               {"of_a_tenth", "asked for 0.1, returns", ".3f"},
               {"of_nine_tenths", "asked for 0.9, returns", ".3f"},
               {"off", "off by at most", ".3f"},
               {"simulation_off", "simulated, off the relation by", ".0e"}}};
  report::Chart chart{
      .name = "restitution",
      .title = fmt::format("Asked for {}, Hunt-Crossley's law returns {:.2f}", asked_for, returned),
      .x = {.label = "restitution asked for", .range = report::Range{0, 1}},
      .y = {.label = "restitution returned", .range = report::Range{0, 1.02}},
      .series = {{"as asked for", report::Mark::line, {{0, 0}, {1, 1}}}},
      .width = 780,
      .height = 460};
  std::vector<std::string_view> faithful;
  for (const auto& [name, law] : contact_law_names()) {
    double off = 0, simulation_off = 0;
    report::Series& series = chart.series.emplace_back();
    series.label = name;
    for (std::size_t k = 2; k <= 98; ++k) {
      const double asked = 0.01 * static_cast<double>(k);
      const double closed = closed_return(law, asked);
      series.samples.push_back({asked, closed});
      off = std::max(off, std::abs(closed - asked));
      if ((k - 2) % stride != 0) continue;
      simulation_off = std::max(simulation_off, std::abs(simulated_return(law, asked) - closed));
    }
    if (off <= faithful_within) faithful.push_back(name);
    table.add(name, closed_return(law, 0.1), closed_return(law, 0.9), off, simulation_off);
  }
  results.set("laws-finding",
              fmt::format("Asked for a restitution of {}, Hunt-Crossley's law returns {:.3f}.",
                          asked_for, returned));
  results.set("energy-asked", asked_for * asked_for);
  results.set("energy-returned", returned * returned);
  results.set("faithful", fmt::format("{}", fmt::join(faithful, ", ")));
  results.add(std::move(table));
  results.add(std::move(chart));
}

}  // namespace ricochet::studies::simulators
