#include "src/studies/dynamics/fidelity.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "problems/carrier_track/check/integrator.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/scene/contact_law.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "src/core/progress.h"
#include "src/core/time_limit.h"

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
  FidelityTotal total;
  for (const auto& row : study.cells) {
    total.equal += row[s].equal;
    total.compared += row[s].compared;
    total.distance += row[s].distance;
    if (!row[s].cost) continue;
    total.least_cost = std::min(total.least_cost.value_or(*row[s].cost), *row[s].cost);
    total.most_cost = std::max(total.most_cost.value_or(*row[s].cost), *row[s].cost);
  }
  total.unfinished =
      static_cast<int>(study.cells.size() * study.plan.speeds.size()) - total.compared;
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

namespace {

/// "21 of 72 counts (29 %)".
std::string agreement(const FidelityTotal& total) {
  return fmt::format("{} of {} counts ({:.0f} %)", total.equal, total.compared,
                     100 * total.share().value_or(0));
}

report::Chart walls_chart(const FidelityStudy& study) {
  report::Chart chart{.name = "fidelity",
                      .x = {"stiffness [N/m^1.5]"},
                      .y = {"case"},
                      .heat_map = report::HeatMap{"equal [%]", {}, report::Range{0, 100}},
                      .width = 620,
                      .height = 420};
  for (const double stiffness : study.plan.stiffnesses)
    chart.x.categories.push_back(name_of(stiffness));
  for (std::size_t c = study.cases.size(); c-- > 0;) {
    chart.y.categories.push_back(study.cases[c]);
    auto& row = chart.heat_map->rows.emplace_back();
    for (const FidelityCell& cell : study.cells[c]) {
      const auto share = cell.share();
      row.push_back(share ? std::optional(std::round(100 * *share)) : std::nullopt);
    }
  }
  const auto told = [&](std::size_t s) {
    return fmt::format("{:.0f} % at {}", 100 * total_of(study, s).share().value_or(0),
                       name_of(study.plan.stiffnesses[s]));
  };
  chart.title = fmt::format("Counts equal to those of hard walls: {}, {}", told(0),
                            told(study.plan.stiffnesses.size() - 1));
  return chart;
}

}  // namespace

void add_to(report::Results& results, const FidelityStudy& study) {
  Table table{"walls",
              {{"stiffness", "stiffness [N/m^1.5]"},
               {"compared", "counts compared"},
               {"equal", "equal to hard walls'"},
               {"share", "equal [%]", ".0%"},
               {"distance", "apart on average", ".2f"},
               {"unfinished", "not finished"},
               {"least_cost", "time over hard walls', least", ".1f"},
               {"most_cost", "most", ".1f"}}};
  const std::vector<double>& stiffnesses = study.plan.stiffnesses;
  for (std::size_t s = 0; s < stiffnesses.size(); ++s) {
    const FidelityTotal total = total_of(study, s);
    table.add(name_of(stiffnesses[s]), total.compared, total.equal, total.share(),
              total.compared > 0 ? std::optional(total.distance / total.compared) : std::nullopt,
              total.unfinished, total.least_cost, total.most_cost);
  }
  results.set(
      "walls",
      fmt::format("Compliant walls of {} N/m^1.5 agree with hard ones in {}, those "
                  "of {} N/m^1.5 in {}.",
                  name_of(stiffnesses.front()), agreement(total_of(study, 0)),
                  name_of(stiffnesses.back()), agreement(total_of(study, stiffnesses.size() - 1))));
  results.set("wall-cases", study.cases.size());
  results.set("wall-speeds", study.plan.speeds.size());
  results.set("first-speed", study.plan.speeds.front());
  results.set("last-speed", study.plan.speeds.back());
  results.add(std::move(table));
  results.add(walls_chart(study));
}

Scene level_scene(const Case& the_case, double direction, double stiffness) {
  Scene scene = scene_of(the_case, default_machine());
  scene.contact_law = ContactLaw::exact_restitution;
  scene.stiffness = stiffness;
  scene.restitution_lower = lower_restitution(scene);
  scene.restitution_upper = upper_restitution(scene);
  scene.contact_friction = false;
  scene.across = Across<double>{direction * scene.pull,
                                scene.wall_lower,
                                scene.wall_upper,
                                scene.restitution_lower,
                                scene.restitution_upper,
                                0.5 * (scene.wall_lower + scene.wall_upper),
                                0.0};
  return scene;
}

namespace {

constexpr double highest = 18;  // [rad/s]

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
  Scene scene = at_speed(level_scene(the_case, 0, plan.stiffness), omega);
  scene.across.reset();
  const Recording hard = record(at_level(scene, Fidelity::impact), default_smoothing, 0);
  finding.doubt = hard.certainty.doubt;
  finding.resolved = !hard.certainty.certain && needed_fidelity(scene) == Fidelity::compliant;
  for (const double direction : plan.directions) {
    scene = at_speed(level_scene(the_case, direction, plan.stiffness), omega);
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
  const Scene scene = level_scene(the_case, plan.directions.back(), plan.stiffness);
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

namespace {

/// All cases with one direction of the yarn.
struct DirectionTotal {
  double coupled = 0, wrong = 0;  ///< shares of the speeds
};

DirectionTotal direction_total(const LevelStudy& study, std::size_t d) {
  int speeds = 0, coupled = 0, wrong = 0;
  for (const LevelRow& row : study.rows) {
    speeds += row.speeds;
    coupled += row.coupled[d];
    wrong += row.wrong[d];
  }
  return {share(coupled, speeds), share(wrong, speeds)};
}

/// Each level's cost over its share of counts that differ from those of hard walls in one
/// direction.
report::Chart levels_chart(const LevelStudy& study, const FidelityStudy& walls) {
  report::Chart chart{.name = "levels",
                      .x = {"processor time over that of hard walls", report::Scale::logarithmic},
                      .y = {"counts that differ from those of hard walls [%]"},
                      .width = 640,
                      .height = 360};
  report::Series hard{"hard walls", report::Mark::points, {{1, 0}}};
  report::Series compliant{"compliant walls, by stiffness", report::Mark::points, {}};
  for (std::size_t s = 0; s < walls.plan.stiffnesses.size(); ++s) {
    const FidelityTotal total = total_of(walls, s);
    if (!total.share() || !total.least_cost) continue;
    compliant.samples.push_back({std::sqrt(*total.least_cost * *total.most_cost),
                                 100 * (1 - *total.share()),
                                 {},
                                 name_of(walls.plan.stiffnesses[s])});
  }
  std::vector<double> costs;
  for (const LevelRow& row : study.rows) costs.push_back(row.seconds[2] / row.seconds[0]);
  std::ranges::sort(costs);
  double most = 0;
  for (std::size_t d = 0; d < study.plan.directions.size(); ++d)
    most = std::max(most, direction_total(study, d).wrong);
  report::Series planar{
      "both directions", report::Mark::points, {{costs[costs.size() / 2], 100 * most}}};
  chart.title =
      fmt::format("Both directions differ from hard walls in {:.0f} % of the counts", 100 * most);
  if (!compliant.samples.empty()) {
    chart.title += fmt::format(", the softest walls in {:.0f} %, the stiffest in {:.0f} %",
                               *compliant.samples.front().value, *compliant.samples.back().value);
  }
  chart.series = {std::move(hard), std::move(planar), std::move(compliant)};
  return chart;
}

}  // namespace

void add_to(report::Results& results, const LevelStudy& study, const FidelityStudy& walls) {
  Table levels{"levels",
               {{"case"},
                {"speeds"},
                {"certain", "certain [%]", ".2%"},
                {"margin", "not: a margin"},
                {"window", "the window"},
                {"graze", "a graze"},
                {"sensitive"},
                {"resolved", "settled by compliant walls"},
                {"compliant", "time over hard walls': compliant", ".1f"},
                {"planar", "", ".1f"},
                {"auto", "", ".1f"}}};
  int speeds = 0, certain = 0, resolved = 0;
  for (const LevelRow& row : study.rows) {
    const auto doubts = [&](Doubt doubt) { return row.doubts[static_cast<std::size_t>(doubt)]; };
    speeds += row.speeds;
    certain += row.certain;
    resolved += row.resolved;
    levels.add(row.id, row.speeds, share(row.certain, row.speeds), doubts(Doubt::margin),
               doubts(Doubt::window), doubts(Doubt::graze), doubts(Doubt::sensitive), row.resolved,
               row.seconds[1] / row.seconds[0], row.seconds[2] / row.seconds[0],
               row.seconds[3] / row.seconds[0]);
  }
  Table directions{"directions",
                   {{"tangent", "tan phi"},
                    {"coupled", "speeds that need both directions [%]", ".1%"},
                    {"wrong", "counts that differ without [%]", ".1%"}}};
  double most = 0;
  for (std::size_t d = 0; d < study.plan.directions.size(); ++d) {
    const DirectionTotal total = direction_total(study, d);
    most = std::max(most, total.wrong);
    directions.add(study.plan.directions[d], total.coupled, total.wrong);
  }
  const std::string others =
      certain == speeds
          ? ""
          : fmt::format("; compliant walls settle {} of the {} others", resolved, speeds - certain);
  results.set(
      "levels-finding",
      fmt::format("Hard walls give a certain count at {} of {} speeds of the paper's cases{}.",
                  certain, speeds, others));
  results.set("planar",
              fmt::format("The second direction, across the track, changes {} of the counts in the "
                          "paper's cases, up to a lateral yarn pull of {:.2g} times that along the "
                          "track. Both sides of this comparison have the same friction.",
                          most == 0 ? "none" : fmt::format("at most {:.2g} %", 100 * most),
                          study.plan.directions.back()));
  results.add(std::move(levels));
  results.add(std::move(directions));
  results.add(levels_chart(study, walls));
}

}  // namespace ricochet::studies::dynamics
