#include "src/studies/dynamics/fidelity.h"

#include <cstdlib>
#include <stdexcept>

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/paper/cases.h"
#include "problems/carrier_track/paper/fitted_reading.h"
#include "src/campaign/progress.h"
#include "src/core/processor_time.h"

namespace ricochet::studies::dynamics {
namespace {

using namespace carrier_track;

struct Count {
  std::optional<int> count;  // none: refused, for too many impacts or steps
  double seconds;            // [s] of processor time
};

Count count_of(const Scene& scene, double omega) {
  const double start = processor_seconds();
  Count result{};
  try {
    result.count = count_at(scene, omega);
  } catch (const std::runtime_error&) {
  }
  result.seconds = processor_seconds() - start;
  return result;
}

}  // namespace

FidelityStudy study_fidelity(const FidelityPlan& plan) {
  FidelityStudy study{plan, {}, {}};
  const std::vector<Case> cases = all_cases();
  Progress progress("hard and compliant walls",
                    static_cast<double>(cases.size() * plan.speeds.size()));
  for (const Case& the_case : cases) {
    study.cases.push_back(the_case.id);
    std::vector<FidelityCell> row(plan.stiffnesses.size());
    std::vector<double> hard_seconds(row.size()), compliant_seconds(row.size());
    Scene scene = scene_of(the_case, default_reading().scene);
    scene.contact_law = ContactLaw::exact_restitution;
    for (const double omega : plan.speeds) {
      scene.fidelity = Fidelity::impact;
      const Count hard = count_of(scene, omega);
      scene.fidelity = Fidelity::compliant;
      for (std::size_t s = 0; s < row.size(); ++s) {
        scene.stiffness = plan.stiffnesses[s];
        const Count compliant = count_of(scene, omega);
        if (!compliant.count || !hard.count) continue;
        ++row[s].compared;
        row[s].equal += compliant.count == hard.count ? 1 : 0;
        row[s].distance += std::abs(*compliant.count - *hard.count);
        hard_seconds[s] += hard.seconds;
        compliant_seconds[s] += compliant.seconds;
      }
      progress.advance(1);
    }
    for (std::size_t s = 0; s < row.size(); ++s) {
      if (hard_seconds[s] > 0) row[s].cost = compliant_seconds[s] / hard_seconds[s];
    }
    study.cells.push_back(std::move(row));
  }
  return study;
}

}  // namespace ricochet::studies::dynamics
