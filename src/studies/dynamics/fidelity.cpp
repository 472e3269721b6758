#include "src/studies/dynamics/fidelity.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "problems/carrier_track/check/integrator.h"
#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/counting/threshold.h"
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

namespace {

constexpr double fastest = 18;          // [rad/s]
constexpr double resolved = 1e-10;      // [rad/s], where the bisection ends
constexpr double repeated_below = 0.1;  // [s]: shorter measurements are repeated three times

/// The count; nothing if the simulation does not finish.
using CountOf = std::function<std::optional<int>(const Scene& scene, double omega)>;

struct TimedSimulation {
  std::string name, kind, control;
  CountOf count;
};

std::string power_of_ten(double value) {
  return fmt::format("1e{:.0f}", std::log10(value));
}

/// A level of the model, set by `change`.
TimedSimulation level_simulation(const std::string& name, const std::string& control,
                                 const std::function<void(Scene&)>& change) {
  return {name, "level", control, [change](const Scene& scene, double omega) -> std::optional<int> {
            Scene there = scene;
            change(there);
            try {
              return count_at(there, omega);
            } catch (const std::runtime_error&) {
              return std::nullopt;
            }
          }};
}

TimedSimulation method_simulation(const Integrator& integrator, double control) {
  const bool fixed = integrator.control == "step [s]";
  return {integrator.name, fixed ? "fixed steps" : "variable steps",
          fmt::format("{} {}", fixed ? "step" : "tolerance", power_of_ten(control)),
          [integrator, control](const Scene& scene, double omega) -> std::optional<int> {
            const Scene there = at_speed(scene, omega);
            const Outcome outcome = integrator.run(there, control);
            return outcome.finished ? std::optional(collisions(there, outcome)) : std::nullopt;
          }};
}

std::vector<TimedSimulation> simulations_of(const ThresholdPlan& plan,
                                            const std::vector<Integrator>& integrators) {
  std::vector<TimedSimulation> all = {
      level_simulation("event-driven", "", [](Scene& scene) { scene.fidelity = Fidelity::impact; }),
      level_simulation("auto", "", [](Scene& scene) { scene.fidelity = Fidelity::automatic; })};
  for (const double stiffness : plan.stiffnesses) {
    all.push_back(level_simulation("compliant", "stiffness " + power_of_ten(stiffness),
                                   [stiffness](Scene& scene) {
                                     scene.fidelity = Fidelity::compliant;
                                     scene.contact_law = ContactLaw::exact_restitution;
                                     scene.stiffness = stiffness;
                                   }));
  }
  for (const Integrator& integrator : integrators) {
    if (integrator.control == "none") continue;  // the event-driven one
    const bool fixed = integrator.control == "step [s]";
    for (const double control : fixed ? plan.steps : plan.tolerances) {
      all.push_back(method_simulation(integrator, control));
    }
  }
  return all;
}

/// A machine whose fastest quiet speed is searched for.
struct QuietProblem {
  Scene scene;
  double quiet_limit;
};

CaseThreshold searched(const CountOf& count, const QuietProblem& problem, double grid) {
  CaseThreshold found;
  const auto is_quiet = [&](double omega) {
    const auto there = count(problem.scene, omega);
    ++found.simulations;
    found.unfinished += there ? 0 : 1;
    return there && *there <= problem.quiet_limit;
  };
  double loud = std::numeric_limits<double>::infinity();
  double quiet = fastest;
  for (; quiet > grid / 2 && !is_quiet(quiet); quiet -= grid) loud = quiet;
  if (quiet <= grid / 2) return found;
  while (std::isfinite(loud) && loud - quiet > resolved) {
    const double middle = (quiet + loud) / 2;
    (is_quiet(middle) ? quiet : loud) = middle;
  }
  found.speed = quiet;
  return found;
}

/// The minimum of three measurements, or one long one, for each simulation.
double seconds_of(const CountOf& count, const Scene& scene, double grid) {
  const int speeds = static_cast<int>(std::lround(fastest / grid));
  double least = std::numeric_limits<double>::infinity();
  for (int repeat = 0; repeat < 3; ++repeat) {
    const double start = processor_seconds();
    for (int k = 1; k <= speeds; ++k) count(scene, k * grid);
    const double seconds = std::max(processor_seconds() - start, 1e-9);
    least = std::min(least, seconds);
    if (seconds > repeated_below) break;
  }
  return least / speeds;
}

/// Error of a case relative to the reference; nothing if either has no threshold.
std::optional<double> error_in(const ThresholdStudy& study, std::size_t s, std::size_t c) {
  const auto& found = study.simulations[s].cases[c].speed;
  const auto& right = study.simulations.front().cases[c].speed;
  return found && right ? std::optional(std::abs(*found - *right)) : std::nullopt;
}

SimulationRow row_of(const ThresholdStudy& study, std::size_t s) {
  const SimulatedThresholds& one = study.simulations[s];
  std::optional<double> least_error, error, least, most;
  double logarithms = 0;
  int missing = 0, unfinished = 0;
  for (std::size_t c = 0; c < one.cases.size(); ++c) {
    const CaseThreshold& there = one.cases[c];
    unfinished += there.unfinished;
    logarithms += std::log(there.seconds) / static_cast<double>(one.cases.size());
    least = std::min(least.value_or(there.seconds), there.seconds);
    most = std::max(most.value_or(there.seconds), there.seconds);
    if (const auto off = error_in(study, s, c)) {
      least_error = std::min(least_error.value_or(*off), *off);
      error = std::max(error.value_or(*off), *off);
    } else {
      ++missing;
    }
  }
  if (missing > 0) error = least_error = std::nullopt;
  // If all are equal, rounding may put the mean outside their range.
  const double mean = std::clamp(std::exp(logarithms), *least, *most);
  return {one.simulation, one.kind, one.control, s == 0,
          mean,           least,    most,        error,
          least_error,    missing,  unfinished,  error && *error <= found_within};
}

}  // namespace

ThresholdStudy study_thresholds(const ThresholdPlan& plan,
                                const std::vector<Integrator>& integrators) {
  ThresholdStudy study{plan, {}};
  std::vector<QuietProblem> problems;
  for (const std::string& id : plan.cases) {
    const Case the_case = find_case(id);
    const Scene scene = scene_of(the_case, default_machine());
    problems.push_back({scene, quiet_limit(quiet_count(scene, the_case.claim, ScanOptions{}))});
  }
  const std::vector<TimedSimulation> simulations = simulations_of(plan, integrators);
  for (const TimedSimulation& one : simulations) {
    study.simulations.push_back(
        {one.name, one.kind, one.control, std::vector<CaseThreshold>(problems.size())});
  }
  Progress progress("thresholds", static_cast<double>(2 * simulations.size()));
  tbb::parallel_for(std::size_t{0}, simulations.size(), [&](std::size_t s) {
    for (std::size_t c = 0; c < problems.size(); ++c) {
      study.simulations[s].cases[c] = searched(simulations[s].count, problems[c], plan.grid);
    }
    progress.advance(1);
  });
  for (std::size_t s = 0; s < simulations.size(); ++s) {  // sequentially, since times are measured
    for (std::size_t c = 0; c < problems.size(); ++c) {
      study.simulations[s].cases[c].seconds =
          seconds_of(simulations[s].count, problems[c].scene, plan.timed_grid);
    }
    progress.advance(1);
  }
  return study;
}

ThresholdData data_of(const ThresholdStudy& study) {
  ThresholdData data{.family = "top-speed",
                     .formulations = {"count", "penalised-count"},
                     .names = study.plan.cases,
                     .tolerance = found_within,
                     .tried = study.simulations.size()};
  for (std::size_t c = 0; c < study.plan.cases.size(); ++c) {
    data.cases.push_back({study.plan.cases[c], study.simulations.front().cases[c].speed});
  }
  for (std::size_t s = 0; s < study.simulations.size(); ++s) {
    const SimulationRow& row = data.simulations.emplace_back(row_of(study, s));
    if (!row.within) continue;
    ++data.within;
    if (!data.cheapest || row.seconds < data.cheapest->seconds) data.cheapest = row;
  }
  return data;
}

}  // namespace ricochet::studies::dynamics
