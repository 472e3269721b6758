#include <fmt/format.h>

#include <algorithm>
#include <concepts>
#include <exception>

#include "problems/carrier_track/motion/observer.h"
#include "problems/carrier_track/motion/simulate.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "ricochet/error.h"
#include "src/core/time_limit.h"
#include "src/studies/simulators/suite.h"

/// What is measured in this process: ricochet, the levels of its model, and the numerical methods.
namespace ricochet::studies::simulators {

namespace {

using namespace carrier_track;

/// Keeps the impacts of hard walls.
struct ImpactList : Observer {
  static constexpr bool hears_impacts_alone = true;
  static constexpr bool hears_stretches() { return false; }

  void impact(double time, Wall wall, double speed) { impacts.push_back({time, wall, speed}); }

  std::vector<Impact> impacts;
};

/// Keeps the impacts of compliant walls, and the deepest point in one.
struct ContactList : Observer {
  explicit ContactList(const Scene& scene) : lower(scene.wall_lower), upper(scene.wall_upper) {}

  static constexpr bool hears_stretches() { return false; }
  void impact(double time, Wall wall, double speed) { impacts.push_back({time, wall, speed}); }
  void contact(double /*time*/, double position, double /*velocity*/) {
    deepest = std::max({deepest, lower - position, position - upper});
  }

  double lower, upper;
  std::vector<Impact> impacts;
  double deepest = 0;
};

/// Simulates a machine with an observer, and returns what it has heard.
template <class List>
Answer simulated(const ScoredScene& scored, const Scene& machine, List list) {
  Answer answer{scored.scene.scene};
  try {
    check(machine, scored.scene.scene);
    const double start = processor_seconds();
    simulate(machine, list);
    answer.seconds = processor_seconds() - start;
    answer.impacts = std::move(list.impacts);
    if constexpr (std::same_as<List, ContactList>) answer.deepest = list.deepest;
  } catch (const InputError& error) {
    answer.ending = Ending::cannot;
    answer.reason = error.what();
  } catch (const std::exception& error) {
    answer.ending = Ending::error;
    answer.reason = error.what();
  }
  return answer;
}

Answer by_hard_walls(const ScoredScene& scored, Level /*level*/) {
  return simulated(scored, scored.machine, ImpactList());
}

/// The impacts are those of the scene itself; the time is that of many speeds next to its own, over
/// their number.
Answer by_scan(const ScoredScene& scored, Level level) {
  constexpr int speeds = 64;
  constexpr double around = 0.005;  // relative
  Answer answer = by_hard_walls(scored, level);
  if (!scored.machine.profile.empty()) {
    answer.ending = Ending::cannot;
    answer.reason = "a scan is over constant speeds";
    return answer;
  }
  std::vector<double> omegas;
  for (int k = 0; k < speeds; ++k) {
    omegas.push_back(scored.machine.omega * (1 + around * (2 * k - speeds + 1) / speeds));
  }
  const double start = processor_seconds();
  counts(scored.machine, omegas);
  answer.seconds = (processor_seconds() - start) / speeds;
  return answer;
}

Answer by_planar(const ScoredScene& scored, Level /*level*/) {
  return simulated(scored, planar_machine(scored.machine), ImpactList());
}

Answer by_compliant_walls(const ScoredScene& scored, Level level) {
  constexpr std::array stiffness = {1e8, 1e11, 1e14};  // [N/m^1.5]
  Scene machine = scored.machine;
  machine.fidelity = Fidelity::compliant;
  machine.contact_law = ContactLaw::exact_restitution;
  machine.stiffness = stiffness[static_cast<std::size_t>(level)];
  return simulated(scored, machine, ContactList(machine));
}

Answer by_method(const Integrator& method, const ScoredScene& scored, Level level) {
  Outcome outcome = method.run(scored.machine, method.levels[static_cast<std::size_t>(level)]);
  Answer answer{scored.scene.scene};
  if (!outcome.finished) {
    answer.ending = Ending::error;
    answer.reason = outcome.failure;
    return answer;
  }
  answer.impacts = std::move(outcome.impacts);
  answer.seconds = outcome.seconds;
  answer.deepest = outcome.deepest;
  return answer;
}

/// What every simulator of our own has.
Simulator own(const char* name, const char* title, const char* kind,
              Answer (*answer)(const ScoredScene&, Level)) {
  Simulator simulator{{}, RICOCHET_VERSION, true, [answer](Level level) -> Ask {
                        return [=](const ScoredScene& scored) { return answer(scored, level); };
                      }};
  simulator.tool.name = name;
  simulator.tool.title = title;
  simulator.tool.kind = kind;
  simulator.tool.levels.fill("no tolerance");
  return simulator;
}

}  // namespace

Scene planar_machine(const Scene& machine) {
  Scene planar = machine;
  planar.fidelity = Fidelity::planar;
  Across<double>& y = planar.across.emplace();
  const bool free = machine.slider_mass_radius == 0 && !machine.pull_rotates;
  if (free && machine.friction > 0) {
    planar.normal_force = machine.normal_force / 2;
    y.pull = -machine.normal_force / 2;
    y.start_position = y.wall_lower;
  } else {
    y.wall_lower = -1e9;
    y.wall_upper = 1e9;
  }
  return planar;
}

std::vector<Simulator> own_simulators() {
  std::vector<Simulator> all = {
      own("ricochet", "ricochet, hard walls in closed form", "ricochet", by_hard_walls),
      own("ricochet-scan", "ricochet, hard walls, each scene at 64 speeds within 1 % at once",
          "ricochet, scan", by_scan),
      own("planar", "ricochet, hard walls in two directions", "ricochet, planar", by_planar),
      own("exact-restitution", "ricochet, compliant walls with the exact damping",
          "ricochet, compliant walls", by_compliant_walls)};
  all.back().tool.levels = {"1e8 N/m^1.5", "1e11 N/m^1.5", "1e14 N/m^1.5"};
  for (const Integrator& method : all_integrators()) {
    if (method.setting == no_setting) continue;
    Simulator& one = all.emplace_back(Simulator{{}, method.version, true, [method](Level level) {
                                                  return [=](const ScoredScene& scored) {
                                                    return by_method(method, scored, level);
                                                  };
                                                }});
    one.tool.name = method.name;
    one.tool.title = method.title;
    one.tool.kind = method.kind;
    for (const Level level : all_levels) {
      const auto k = static_cast<std::size_t>(level);
      one.tool.levels[k] = fmt::format("{} {:.3g}", method.setting, method.levels[k]);
    }
  }
  return all;
}

}  // namespace ricochet::studies::simulators
