#include "src/studies/dynamics/levels.h"

#include <tbb/parallel_for.h>

#include <cmath>

#include "problems/carrier_track/counting/collisions.h"
#include "problems/carrier_track/counting/fidelity_choice.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/paper/cases.h"
#include "problems/carrier_track/paper/fitted_reading.h"
#include "src/campaign/progress.h"
#include "src/core/processor_time.h"

namespace ricochet::studies::dynamics {
namespace {

using namespace carrier_track;
using report::Json;

constexpr double highest = 18;  // [rad/s]

Scene scene_with(const Case& the_case, double direction, double stiffness) {
  Scene scene = scene_of(the_case, default_reading().scene);
  scene.contact_law = ContactLaw::exact_restitution;
  scene.stiffness = stiffness;
  scene.contact_friction = false;  // y has its own, of the wall's force
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
  const Recording hard = record(at_level(scene, Fidelity::impact), default_width, 0);
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

Json data_of(const LevelStudy& study) {
  Json data = {{"stiffness", study.plan.stiffness},
               {"directions", Json::array()},
               {"cases", Json::array()},
               {"costs", Json::array()},
               {"wrong", Json::array()}};
  int speeds = 0, certain = 0, resolved = 0;
  for (const LevelRow& row : study.rows) {
    speeds += row.speeds;
    certain += row.certain;
    resolved += row.resolved;
    const auto doubts = [&](Doubt doubt) { return row.doubts[static_cast<std::size_t>(doubt)]; };
    data["cases"].push_back({{"case", row.id},
                             {"speeds", row.speeds},
                             {"certain", share(row.certain, row.speeds)},
                             {"margin", doubts(Doubt::margin)},
                             {"window", doubts(Doubt::window)},
                             {"graze", doubts(Doubt::graze)},
                             {"sensitive", doubts(Doubt::sensitive)},
                             {"resolved", row.resolved}});
    Json shares = Json::array();  // a direction each
    for (const int wrong : row.wrong) shares.push_back(share(wrong, row.speeds));
    data["wrong"].push_back({{"case", row.id}, {"shares", std::move(shares)}});
    data["costs"].push_back({{"case", row.id},
                             {"compliant", row.seconds[1] / row.seconds[0]},
                             {"planar", row.seconds[2] / row.seconds[0]},
                             {"automatic", row.seconds[3] / row.seconds[0]}});
  }
  data["speeds"] = speeds;
  data["certain"] = certain;
  data["certain_share"] = share(certain, speeds);
  data["uncertain"] = speeds - certain;
  data["resolved"] = resolved;
  for (std::size_t d = 0; d < study.plan.directions.size(); ++d) {
    int coupled = 0, wrong = 0;
    for (const LevelRow& row : study.rows) {
      coupled += row.coupled[d];
      wrong += row.wrong[d];
    }
    data["directions"].push_back({{"tangent", study.plan.directions[d]},
                                  {"coupled", share(coupled, speeds)},
                                  {"wrong", share(wrong, speeds)}});
  }
  return data;
}

}  // namespace ricochet::studies::dynamics
