#include "src/research/dynamics/levels.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/counting/fidelity_choice.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/problems/cases.h"
#include "problems/carrier_track/problems/default_machine.h"
#include "ricochet/recording.h"
#include "src/core/processor_time.h"
#include "src/core/progress.h"

namespace ricochet::studies::dynamics {
namespace {

using namespace carrier_track;

constexpr double highest = 18;  // [rad/s]

Scene scene_with(const Case& the_case, double direction, double stiffness) {
  Scene scene = scene_of(the_case, default_machine());
  scene.contact_law = ContactLaw::exact_restitution;
  scene.stiffness = stiffness;
  scene.contact_friction = false;  // y has a contact friction of its own
  scene.across = Across<double>{direction * scene.pull,
                                scene.wall_lower,
                                scene.wall_upper,
                                scene.restitution_lower,
                                scene.restitution_upper,
                                0.5 * (scene.wall_lower + scene.wall_upper),
                                0.0};
  return scene;
}

Scene at_level(Scene scene, Fidelity level) {
  scene.fidelity = level;
  return scene;
}

/// What one speed adds to a row, all but the times.
struct Finding {
  Doubt doubt = Doubt::none;
  bool resolved = false;
  std::vector<bool> coupled, wrong;
};

Finding find(const Case& the_case, double omega, const LevelPlan& plan) {
  Finding finding;
  Scene scene = at_speed(scene_with(the_case, 0, plan.stiffness), omega);
  scene.across.reset();
  const Recording hard = record(at_level(scene, Fidelity::impact), default_smoothing, 0);
  finding.doubt = hard.certainty.doubt;
  finding.resolved = !hard.certainty.certain && needed_fidelity(scene) == Fidelity::compliant;
  for (const double direction : plan.directions) {
    scene = at_speed(scene_with(the_case, direction, plan.stiffness), omega);
    const bool coupled = couples(scene);
    finding.coupled.push_back(coupled);
    finding.wrong.push_back(coupled &&
                            count_at(at_level(scene, Fidelity::planar), omega) != hard.count);
  }
  return finding;
}

double seconds_of(const Scene& scene, Fidelity level, double omega) {
  const Scene timed = at_level(scene, level);
  const double start = processor_seconds();
  count_at(timed, omega);
  return processor_seconds() - start;
}

void time_levels(const Case& the_case, const LevelPlan& plan, LevelRow& row) {
  const Scene scene = scene_with(the_case, plan.directions.back(), plan.stiffness);
  Scene alone = scene;
  alone.across.reset();
  for (int k = 1; k <= row.speeds; k += static_cast<int>(plan.cost_stride)) {
    const double omega = k * plan.step;
    row.seconds[0] += seconds_of(alone, Fidelity::impact, omega);
    row.seconds[1] += seconds_of(alone, Fidelity::compliant, omega);
    row.seconds[2] += seconds_of(scene, Fidelity::planar, omega);
    row.seconds[3] += seconds_of(alone, Fidelity::automatic, omega);
  }
}

double share(int part, int whole) {
  return whole > 0 ? 1.0 * part / whole : 0.0;
}

}  // namespace

LevelStudy study_levels(const LevelPlan& plan) {
  LevelStudy study{plan, {}};
  const std::vector<Case> cases = all_cases();
  Progress progress("levels of the model", static_cast<double>(cases.size()));
  for (const Case& the_case : cases) {
    LevelRow row;
    row.id = the_case.id;
    row.speeds = static_cast<int>(std::lround(highest / plan.step));
    row.coupled.assign(plan.directions.size(), 0);
    row.wrong = row.coupled;
    std::vector<Finding> findings(static_cast<std::size_t>(row.speeds));
    tbb::parallel_for(0, row.speeds, [&](int k) {
      findings[static_cast<std::size_t>(k)] = find(the_case, (k + 1) * plan.step, plan);
    });
    for (const Finding& finding : findings) {
      ++row.doubts[static_cast<std::size_t>(finding.doubt)];
      row.resolved += finding.resolved;
      for (std::size_t d = 0; d < plan.directions.size(); ++d) {
        row.coupled[d] += finding.coupled[d];
        row.wrong[d] += finding.wrong[d];
      }
    }
    row.certain = row.doubts[static_cast<std::size_t>(Doubt::none)];
    time_levels(the_case, plan, row);
    study.rows.push_back(std::move(row));
    progress.advance(1);
  }
  return study;
}

LevelData data_of(const LevelStudy& study) {
  LevelData data{.stiffness = study.plan.stiffness};
  std::vector<int> coupled(study.plan.directions.size(), 0), wrong = coupled;
  for (const LevelRow& row : study.rows) {
    const auto doubts = [&](Doubt doubt) { return row.doubts[static_cast<std::size_t>(doubt)]; };
    data.speeds += row.speeds;
    data.certain += row.certain;
    data.resolved += row.resolved;
    data.cases.push_back({row.id, row.speeds, share(row.certain, row.speeds), doubts(Doubt::margin),
                          doubts(Doubt::window), doubts(Doubt::graze), doubts(Doubt::sensitive),
                          row.resolved});
    data.costs.push_back({row.id, row.seconds[1] / row.seconds[0], row.seconds[2] / row.seconds[0],
                          row.seconds[3] / row.seconds[0]});
    WrongShares& shares = data.wrong.emplace_back(WrongShares{row.id, {}});
    for (std::size_t d = 0; d < wrong.size(); ++d) {
      shares.shares.push_back(share(row.wrong[d], row.speeds));
      coupled[d] += row.coupled[d];
      wrong[d] += row.wrong[d];
    }
  }
  data.certain_share = share(data.certain, data.speeds);
  data.uncertain = data.speeds - data.certain;
  for (std::size_t d = 0; d < wrong.size(); ++d) {
    data.directions.push_back(
        {study.plan.directions[d], share(coupled[d], data.speeds), share(wrong[d], data.speeds)});
  }
  return data;
}

std::vector<LevelCost> level_costs(const FidelityData& walls, const LevelData& levels) {
  std::vector<LevelCost> costs = {{"hard walls", true, 1, 0}};
  for (const FidelityTotal& wall : walls.stiffnesses) {
    if (!wall.share || !wall.least_cost) continue;
    costs.push_back({"stiffness " + wall.stiffness, false,
                     std::sqrt(*wall.least_cost * *wall.most_cost), 1 - *wall.share});
  }
  std::vector<double> planar;
  for (const LevelCosts& one : levels.costs) planar.push_back(one.planar);
  std::ranges::sort(planar);
  for (const LevelDirection& direction : levels.directions) {
    costs.push_back({fmt::format("both directions, tan phi {:.2g}", direction.tangent), false,
                     planar[planar.size() / 2], direction.wrong});
  }
  return costs;
}

PlanarNeed planar_need(const LevelData& levels) {
  return {std::ranges::max(levels.directions, {}, &LevelDirection::wrong).wrong,
          levels.directions.back().tangent};
}

}  // namespace ricochet::studies::dynamics
