#include "src/studies/impact_test/simulator.h"

#include <algorithm>
#include <exception>
#include <memory>

#include "problems/carrier_track/motion/observer.h"
#include "problems/carrier_track/motion/simulate.h"
#include "problems/carrier_track/scene/scene_check.h"
#include "ricochet/error.h"
#include "ricochet/machine.h"
#include "src/core/time_limit.h"
#include "src/studies/impact_test/tool.h"

namespace ricochet::studies::impact_test {

std::vector<Simulator> own_simulators() {
  std::vector<Simulator> simulators;
  for (const OwnLevel& own : own_levels()) {
    const auto open = [answer = own.answer](Level level) -> Ask {
      return [answer, level](const ScoredScene& scored) { return answer(scored, level); };
    };
    simulators.push_back({own.tool, RICOCHET_VERSION, true, open});
  }
  return simulators;
}

Simulator simulator_of(const ToolProgram& program, const std::filesystem::path& logs) {
  const auto open = [program, logs](Level level) -> Ask {
    std::filesystem::create_directories(logs);
    const auto session =
        std::make_shared<ToolSession>(program, level, logs / (program.tool.name + ".log"));
    return [session](const ScoredScene& scored) { return session->ask(scored.scene); };
  };
  return {program.tool, program.version, false, open};
}

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

template <ContactLaw law>
Answer by_compliant(const ScoredScene& scored, Level level) {
  Scene machine = scored.machine;
  machine.fidelity = Fidelity::compliant;
  machine.contact_law = law;
  machine.stiffness = stiffness_of(level);
  return simulated(scored, machine, ContactList(machine));
}

Tool compliant(const char* name, const char* title, const char* sets) {
  return {name,
          title,
          "ricochet, compliant walls",
          {},
          {},
          "",
          {},
          {},
          {"1e8 N/m^1.5", "1e11 N/m^1.5", "1e14 N/m^1.5"},
          sets,
          "a stiffness so high that a contact is over before the forces change"};
}

}  // namespace

double stiffness_of(Level level) {
  constexpr std::array stiffness = {1e8, 1e11, 1e14};
  return stiffness[static_cast<std::size_t>(level)];
}

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

const std::vector<OwnLevel>& own_levels() {
  static const std::vector<OwnLevel> levels = {
      {{"ricochet",
        "ricochet, hard walls in closed form",
        "ricochet",
        {},
        {},
        "",
        {},
        {},
        {"no tolerance", "no tolerance", "no tolerance"},
        "Newton's restitution and Coulomb's friction, exactly",
        "nothing to set"},
       by_hard_walls},
      {{"ricochet-scan",
        "ricochet, hard walls, each scene at 64 speeds within 1 % at once",
        "ricochet, scan",
        {},
        {},
        "",
        {},
        {},
        {"no tolerance", "no tolerance", "no tolerance"},
        "as ricochet; the time is that of all speeds over their number",
        "nothing to set"},
       by_scan},
      {{"planar",
        "ricochet, hard walls in two directions",
        "ricochet, planar",
        {},
        {},
        "",
        {},
        {},
        {"no tolerance", "no tolerance", "no tolerance"},
        "half of the friction by a press on a wall across, where no other force acts there",
        "nothing to set"},
       by_planar},
      {compliant("exact-restitution", "ricochet, compliant walls with the exact damping",
                 "the damping that returns the restitution; not 0"),
       by_compliant<ContactLaw::exact_restitution>},
      {compliant("hunt-crossley", "ricochet, compliant walls by Hunt and Crossley",
                 "the damping D = 3 (1 - e) / 2, which returns e for e near 1"),
       by_compliant<ContactLaw::hunt_crossley>},
      {compliant("flores", "ricochet, compliant walls by Flores",
                 "the damping D = 8 (1 - e) / (5 e), which returns nearly e"),
       by_compliant<ContactLaw::flores>},
  };
  return levels;
}

}  // namespace ricochet::studies::impact_test
