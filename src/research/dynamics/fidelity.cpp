#include "src/studies/dynamics/fidelity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/paper/cases.h"
#include "problems/carrier_track/paper/fitted_reading.h"
#include "src/campaign/progress.h"
#include "src/core/processor_time.h"

namespace ricochet::studies::dynamics {
namespace {

using namespace carrier_track;
using report::Json;

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

std::string name_of(double stiffness) {
  return fmt::format("1e{:.0f}", std::log10(stiffness));
}

/// All cases with one stiffness.
Json total_of(const FidelityStudy& study, std::size_t s) {
  FidelityCell total;
  std::optional<double> least, most;  // cost of a case
  for (const auto& row : study.cells) {
    total.equal += row[s].equal;
    total.distance += row[s].distance;
    total.compared += row[s].compared;
    if (!row[s].cost) continue;
    least = std::min(least.value_or(*row[s].cost), *row[s].cost);
    most = std::max(most.value_or(*row[s].cost), *row[s].cost);
  }
  const auto tried = static_cast<int>(study.cells.size() * study.plan.speeds.size());
  return {{"stiffness", name_of(study.plan.stiffnesses[s])},
          {"compared", total.compared},
          {"equal", total.equal},
          {"share", total.share()},
          {"distance", total.compared > 0 ? Json(1.0 * total.distance / total.compared) : Json()},
          {"unfinished", tried - total.compared},
          {"least_cost", least},
          {"most_cost", most}};
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

Json data_of(const FidelityStudy& study) {
  const std::vector<double>& speeds = study.plan.speeds;
  Json data = {
      {"cases", study.cases.size()},
      {"speeds", {{"tried", speeds.size()}, {"first", speeds.front()}, {"last", speeds.back()}}},
      {"stiffnesses", Json::array()},
      {"shares", Json::array()}};
  for (std::size_t c = 0; c < study.cases.size(); ++c) {
    data["shares"].push_back({{"case", study.cases[c]},
                              {"equal", report::list_of(study.cells[c], &FidelityCell::share)}});
  }
  for (std::size_t s = 0; s < study.plan.stiffnesses.size(); ++s) {
    data["stiffnesses"].push_back(total_of(study, s));
  }
  return data;
}

}  // namespace ricochet::studies::dynamics
