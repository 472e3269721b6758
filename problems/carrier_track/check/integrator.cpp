#include "problems/carrier_track/check/integrator.h"

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <utility>

#include "problems/carrier_track/check/walls.h"
#include "problems/carrier_track/counting/count.h"
#include "src/core/time_limit.h"

namespace ricochet::carrier_track::inline reference_integrators {

void add_impact(Outcome& outcome, double time, Wall wall, double speed) {
  if (outcome.impacts.size() == most_impacts) throw std::runtime_error("more than 1000000 impacts");
  outcome.impacts.push_back({time, wall, speed});
}

Integrator measured(Integrator integrator) {
  integrator.run = [run = std::move(integrator.run)](const Scene& scene, double setting) {
    const double start = processor_seconds();
    Outcome outcome;
    try {
      outcome = run(scene, setting);
    } catch (const std::exception& error) {  // before the first step
      outcome.end = {0.0, scene.start_position, scene.start_velocity};
      outcome.failure = error.what();
    }
    outcome.finished = outcome.failure.empty();
    outcome.seconds = processor_seconds() - start;
    return outcome;
  };
  return integrator;
}

namespace {

struct ImpactCollector : Observer {
  explicit ImpactCollector(Outcome& into) : outcome(into) {}
  void impact(double time, Wall wall, double speed) { add_impact(outcome, time, wall, speed); }

  Outcome& outcome;
};

/// ImpactModel: flights in closed form, events by conservative advancement. For compliant walls the
/// CompliantModel at its tightest tolerance, 1e-12.
Outcome run_event_driven(const Scene& scene, double /*setting*/) {
  Outcome outcome;
  ImpactCollector collector(outcome);
  try {
    const bool compliant = scene.fidelity == Fidelity::compliant && scene.profile.empty();
    const End<double> end = compliant ? CompliantModel(scene, 1e-12).run(collector)
                                      : simulate_at_needed_fidelity(scene, collector);
    outcome.end = {end.time, end.position, end.velocity};
    outcome.force_evaluations = end.evaluations;
  } catch (const std::runtime_error& error) {
    outcome.failure = error.what();
  }
  return outcome;
}

}  // namespace

std::vector<Integrator> all_integrators() {
  const Integrator event_driven = {"event-driven",
                                   "ricochet " RICOCHET_VERSION,
                                   "ricochet, flights in closed form",
                                   "closed form",
                                   no_setting,
                                   {},
                                   true,
                                   run_event_driven};
  return {
      measured(event_driven), odeint_dopri5(), odeint_rosenbrock4(),
#ifdef RICOCHET_HAS_SUNDIALS
      cvode_adams(),          cvode_bdf(),
#endif
      semi_implicit_euler(),  runge_kutta_4(), moreau_jean(),        penalty(),
  };
}

std::vector<std::string> methods_not_built() {
#ifdef RICOCHET_HAS_SUNDIALS
  return {};
#else
  return {"cvode-adams", "cvode-bdf"};
#endif
}

int collisions(const Scene& scene, const Outcome& outcome) {
  return static_cast<int>(std::ranges::count_if(
      outcome.impacts, [&](const Impact& impact) { return impact.speed > scene.counting_limit; }));
}

}  // namespace ricochet::carrier_track::inline reference_integrators
