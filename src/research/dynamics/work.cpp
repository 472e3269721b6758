#include "src/research/dynamics/work.h"

#include <algorithm>
#include <cmath>

#include "problems/carrier_track/models/impact_model.h"
#include "src/core/processor_time.h"

namespace ricochet::studies::dynamics {
namespace {

using namespace carrier_track;

constexpr double shortest_measurement = 5e-4;  // [s]
constexpr double longest_repeated = 0.03;      // [s]

/// `per_decade` numbers of every decade from `first` down to `last`.
std::vector<double> controls(double first, double last, int per_decade) {
  const auto count = static_cast<int>(std::lround(per_decade * std::log10(first / last)));
  std::vector<double> values;
  for (int k = 0; k <= count; ++k) {
    values.push_back(first * std::pow(10.0, -static_cast<double>(k) / per_decade));
  }
  return values;
}

struct Measured {
  Outcome outcome;
  double seconds;  // [s] of processor time per run
};

Measured measure(const Integrator& integrator, const Scene& scene, double control) {
  double start = processor_seconds();
  Measured measured{integrator.run(scene, control), 0};
  measured.seconds = std::max(processor_seconds() - start, 1e-9);
  if (measured.seconds > longest_repeated) return measured;
  const int runs =
      static_cast<int>(std::clamp(std::ceil(shortest_measurement / measured.seconds), 1.0, 1e4));
  for (int repeat = 0; repeat < 3; ++repeat) {
    start = processor_seconds();
    for (int i = 0; i < runs; ++i) integrator.run(scene, control);
    measured.seconds = std::min(measured.seconds, (processor_seconds() - start) / runs);
  }
  return measured;
}

std::optional<double> error_of(const SceneWork& work, const Trial& trial) {
  const Accuracy& accuracy = trial.accuracy;
  if (!trial.finished) return std::nullopt;
  if (work.benchmark.chaotic) {
    const int impacts = work.impacts + accuracy.count_difference;
    if (impacts == 0) return std::nullopt;
    return std::abs(impacts / work.mean_impacts - 1);
  }
  if (accuracy.missed + accuracy.spurious > 0) return std::nullopt;
  const auto& error = accuracy.impact_time_error;
  return error && std::isfinite(*error) ? error : std::nullopt;
}

void measure_spread(const Integrator& reference, SceneWork& work) {
  constexpr int starts = 32;
  double sum = 0;
  double squares = 0;
  for (int k = 1; k <= starts; ++k) {
    Scene beside = work.benchmark.scene;
    beside.start_velocity *= 1 + 1e-12 * k;
    const double impacts = collisions(beside, reference.run(beside, 0));
    sum += impacts;
    squares += impacts * impacts;
  }
  work.mean_impacts = sum / starts;
  const double variance = squares / starts - work.mean_impacts * work.mean_impacts;
  work.rate_spread = 3 * std::sqrt(std::max(variance, 0.0)) / work.mean_impacts;
}

MethodWork work_of(const Integrator& integrator, const SceneWork& scene_work,
                   const Outcome& reference, const WorkPlan& plan) {
  const Scene& scene = scene_work.benchmark.scene;
  MethodWork work{integrator.name, integrator.control, {}};
  std::vector<double> values = {1.0};
  if (integrator.control == "step [s]") {
    const double pause = duration_of(scene) / scene_work.impacts;  // [s] between two impacts
    values = controls(0.1 * pause, pause / plan.steps, plan.per_decade);
  } else if (integrator.control != "none") {
    values = controls(1e-3, plan.tolerance, plan.per_decade);
  }
  for (const double control : values) {
    const Measured measured = measure(integrator, scene, control);
    const Outcome& outcome = measured.outcome;
    Trial trial{control, measured.seconds, outcome.force_evaluations, outcome.finished,
                {},      std::nullopt};
    if (outcome.finished) trial.accuracy = compare(scene, outcome, reference);
    trial.error = error_of(scene_work, trial);
    work.trials.push_back(trial);
  }
  return work;
}

}  // namespace

SceneWork work_in(const BenchmarkScene& benchmark, const WorkPlan& plan,
                  const std::vector<Integrator>& integrators, const std::function<void()>& done) {
  const Integrator& first = integrators.front();
  const Outcome reference = first.run(benchmark.scene, 0);
  SceneWork work;
  work.benchmark = benchmark;
  work.impacts = std::max(collisions(benchmark.scene, reference), 1);
  if (benchmark.chaotic) measure_spread(first, work);
  for (const Integrator& integrator : integrators) {
    work.methods.push_back(work_of(integrator, work, reference, plan));
    done();
  }
  return work;
}

std::optional<Trial> loosest_within(const MethodWork& method, double limit) {
  std::optional<Trial> loosest;
  for (auto trial = method.trials.rbegin(); trial != method.trials.rend(); ++trial) {
    if (!trial->error || *trial->error > limit) break;
    loosest = *trial;
  }
  return loosest;
}

}  // namespace ricochet::studies::dynamics
