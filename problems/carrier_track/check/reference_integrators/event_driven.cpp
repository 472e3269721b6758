#include <stdexcept>

#include "problems/carrier_track/check/reference_integrators/methods.h"
#include "problems/carrier_track/counting/fidelity_choice.h"
#include "ricochet/recording.h"

namespace ricochet::carrier_track::inline reference_integrators {
namespace {

class ImpactCollector : public Observer {
 public:
  explicit ImpactCollector(std::vector<Impact>& impacts) : impacts_(impacts) {}

  void impact(double time, Wall wall, double speed) {
    if (impacts_.size() == most_impacts) throw std::runtime_error("more than 1000000 impacts");
    impacts_.push_back({time, wall, speed});
  }

 private:
  std::vector<Impact>& impacts_;
};

Outcome run(const Scene& scene, double /*control*/) {
  Outcome outcome;
  ImpactCollector collector(outcome.impacts);
  try {
    const bool compliant = scene.fidelity == Fidelity::compliant && scene.profile.empty();
    const End<double> end = compliant ? CompliantModel(scene, 1e-12).run(collector)
                                      : simulate_at_needed_fidelity(scene, collector);
    outcome.end = {end.time, end.position, end.velocity};
    outcome.force_evaluations = end.evaluations;
    outcome.finished = true;
  } catch (const std::runtime_error& error) {
    outcome.failure = error.what();
  }
  return outcome;
}

}  // namespace

Integrator event_driven() {
  return {"event-driven", "ricochet " RICOCHET_VERSION, "none", run};
}

}  // namespace ricochet::carrier_track::inline reference_integrators
