#include "src/research/dynamics/fidelity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/problems/cases.h"
#include "problems/carrier_track/problems/default_machine.h"
#include "src/core/processor_time.h"
#include "src/core/progress.h"

namespace ricochet::studies::dynamics {
namespace {

using namespace carrier_track;

struct Count {
  std::optional<int> count;  // nothing: rejected for too many impacts or steps
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

std::string name_of(double stiffness) {
  return fmt::format("1e{:.0f}", std::log10(stiffness));
}

FidelityTotal total_of(const FidelityStudy& study, std::size_t s) {
  FidelityTotal total{.stiffness = name_of(study.plan.stiffnesses[s])};
  int distance = 0;
  for (const auto& row : study.cells) {
    total.equal += row[s].equal;
    total.compared += row[s].compared;
    distance += row[s].distance;
    if (!row[s].cost) continue;
    total.least_cost = std::min(total.least_cost.value_or(*row[s].cost), *row[s].cost);
    total.most_cost = std::max(total.most_cost.value_or(*row[s].cost), *row[s].cost);
  }
  if (total.compared > 0) {
    total.share = static_cast<double>(total.equal) / total.compared;
    total.distance = 1.0 * distance / total.compared;
  }
  const auto tried = static_cast<int>(study.cells.size() * study.plan.speeds.size());
  total.unfinished = tried - total.compared;
  return total;
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
    Scene scene = scene_of(the_case, default_machine());
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

FidelityData data_of(const FidelityStudy& study) {
  const std::vector<double>& speeds = study.plan.speeds;
  FidelityData data{study.cases.size(), {speeds.size(), speeds.front(), speeds.back()}, {}, {}};
  for (std::size_t s = 0; s < study.plan.stiffnesses.size(); ++s) {
    data.stiffnesses.push_back(total_of(study, s));
  }
  for (std::size_t c = 0; c < study.cases.size(); ++c) {
    FidelityShares& shares = data.shares.emplace_back(FidelityShares{study.cases[c], {}});
    for (const FidelityCell& cell : study.cells[c]) shares.equal.push_back(cell.share());
  }
  return data;
}

}  // namespace ricochet::studies::dynamics
