#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/machine.h"
#include "ricochet/machine.h"
#include "src/core/progress.h"
#include "src/core/time_limit.h"
#include "src/studies/dynamics/fidelity.h"

namespace ricochet::studies::dynamics {

using namespace carrier_track;

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
  const bool fixed = integrator.setting == "step [s]";
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
    if (integrator.setting == "none") continue;  // the event-driven one
    const bool fixed = integrator.setting == "step [s]";
    for (const double control : fixed ? plan.steps : plan.tolerances) {
      all.push_back(method_simulation(integrator, control));
    }
  }
  return all;
}

/// A machine whose top speed in the window is searched for.
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

/// Cost and error of one method of simulation over the cases.
struct Simulation {
  double seconds = 1;                        ///< per simulation: geometric mean of the cases
  std::optional<double> least, most;         ///< of a case
  std::optional<double> error, least_error;  ///< [rad/s] of a case; none if any is missing
  int unfinished = 0;

  bool within() const { return error && *error <= found_within; }
};

Simulation simulation_of(const ThresholdStudy& study, std::size_t s) {
  Simulation all;
  double logarithms = 0;
  bool missing = false;
  const std::vector<CaseThreshold>& cases = study.simulations[s].cases;
  for (std::size_t c = 0; c < cases.size(); ++c) {
    const CaseThreshold& there = cases[c];
    all.unfinished += there.unfinished;
    logarithms += std::log(there.seconds) / static_cast<double>(cases.size());
    all.least = std::min(all.least.value_or(there.seconds), there.seconds);
    all.most = std::max(all.most.value_or(there.seconds), there.seconds);
    const auto off = error_in(study, s, c);
    missing = missing || !off;
    if (!off) continue;
    all.least_error = std::min(all.least_error.value_or(*off), *off);
    all.error = std::max(all.error.value_or(*off), *off);
  }
  if (missing) all.error = all.least_error = std::nullopt;
  // If all are equal, rounding may put the mean outside their range.
  all.seconds = std::clamp(std::exp(logarithms), *all.least, *all.most);
  return all;
}

constexpr double least_error_drawn = 1e-10;  // [rad/s], where the bisection ends

/// Time and error of every simulation; those of one method are joined.
report::Chart thresholds_chart(const ThresholdStudy& study) {
  report::Chart chart{
      .name = "thresholds",
      .x = {"processor time of a simulation [s]", report::Scale::logarithmic},
      .y = {"error of the top speed in the window [rad/s]", report::Scale::logarithmic},
      .lines = {{report::Direction::horizontal, found_within, "solved"}},
      .width = 760,
      .height = 440};
  for (std::size_t s = 0; s < study.simulations.size(); ++s) {
    const SimulatedThresholds& one = study.simulations[s];
    const Simulation all = simulation_of(study, s);
    if (!all.error) continue;
    if (chart.series.empty() || chart.series.back().label != one.simulation)
      chart.series.push_back({one.simulation, report::Mark::points, {}});
    chart.series.back().samples.push_back({all.seconds, std::max(*all.error, least_error_drawn)});
  }
  const auto within = std::ranges::count_if(chart.series, [](const report::Series& series) {
    return std::ranges::any_of(series.samples,
                               [](const auto& sample) { return *sample.value <= found_within; });
  });
  chart.title = fmt::format("{} of {} levels and methods find the top speed in the window", within,
                            chart.series.size());
  return chart;
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

void add_to(report::Results& results, const ThresholdStudy& study) {
  Table table{"thresholds",
              {{"simulation"},
               {"control", "tolerance or step"},
               {"seconds", "time [s]", ".2g"},
               {"seconds_least", "least", ".2g"},
               {"seconds_most", "most", ".2g"},
               {"error", "error [rad/s]", ".1e"},
               {"error_least", "least", ".1e"},
               {"unfinished", "runs that do not end"},
               {"within", "solved", "mark"}}};
  int within = 0;
  std::optional<double> least;
  std::string cheapest;
  for (std::size_t s = 0; s < study.simulations.size(); ++s) {
    const SimulatedThresholds& one = study.simulations[s];
    const Simulation all = simulation_of(study, s);
    table.add(one.simulation, one.control, all.seconds, all.least, all.most, all.error,
              all.least_error, all.unfinished, all.within());
    within += all.within();
    if (!all.within() || (least && all.seconds >= *least)) continue;
    least = all.seconds;
    cheapest = one.simulation;
  }
  const auto tried = static_cast<int>(study.simulations.size());
  results.set(
      "thresholds-finding",
      fmt::format("{} of {} ways to simulate give the top speed in the window of {} within {} "
                  "rad/s, {} do not. The cheapest is {}, with {:.2g} s a simulation.",
                  within, tried, fmt::join(study.plan.cases, ", "), found_within, tried - within,
                  cheapest, least.value_or(0)));
  results.add(sorted(std::move(table), {"-within", "seconds"}));
  results.add(thresholds_chart(study));
}

}  // namespace ricochet::studies::dynamics
