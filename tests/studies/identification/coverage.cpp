#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/identification/knock_record.h"
#include "ricochet/solver.h"
#include "src/core/files.h"
#include "src/core/time_limit.h"
#include "src/identification/identified_machine.h"
#include "tests/carrier_track/identification/synthetic_knocks.h"

/// How often the intervals of `ricochet identify` hold the truth, by synthetic records of one
/// machine, each with another phase, other errors and another guess:
///
///   ricochet_identify_coverage MACHINE TRIALS [THREADS [KIND [SOLVER [FIRST]]]]
///   ricochet_identify_coverage MACHINE FOLDER
///
/// KIND is one or more of marks, strengths, and constant or steps in place of a ramp, and one of
/// the faults of a measurement below, joined by +. A record whose intervals are refused counts as
/// such, not as covered or not. The second form writes a record as files instead: knocks.csv,
/// speed.csv, marks.csv.
namespace ricochet::studies::identification {
namespace {

using namespace carrier_track;

constexpr double outlying = 5;  // deviations, at which a trial is named

struct Kind {
  bool marks, constant, steps;
  SensorModel sensor = {};
  double mark_error = 0;  ///< [rad]
};

constexpr double degree = std::numbers::pi / 180;

/// What is wrong with a measurement.
const std::map<std::string, void (*)(Kind&)> faults = {
    {"lag-0.5ms", [](Kind& k) { k.sensor.lag = 0.5e-3; }},
    {"lag-2ms", [](Kind& k) { k.sensor.lag = 2e-3; }},
    {"lag-10ms", [](Kind& k) { k.sensor.lag = 10e-3; }},
    {"mark-0.5deg", [](Kind& k) { k.mark_error = 0.5 * degree; }},
    {"mark-1deg", [](Kind& k) { k.mark_error = 1 * degree; }},
    {"mark-3deg", [](Kind& k) { k.mark_error = 3 * degree; }},
    {"echoes", [](Kind& k) { k.sensor.echo_delay = 4e-3; }},
    {"drift-100ppm", [](Kind& k) { k.sensor.drift = 1e-4; }},
    {"dead-time-10ms", [](Kind& k) { k.sensor.dead_time = 10e-3; }},
    {"one-wall", [](Kind& k) { k.sensor.upper_gain = 0.01; }},
    {"saturated", [](Kind& k) { k.sensor.saturation = 0.06; }},
};

/// A constant, or the safe speed, as it was found.
struct Found {
  double error;  ///< relative
  double score;  ///< error over standard deviation, on the scale of the interval
  bool covered;
};

struct Trial {
  bool failed = false;
  bool refused = false;  ///< the record contradicts the model: there are no intervals
  std::vector<Found> found = {};
  /// The truth explains the record better than the fit: the search has missed a maximum.
  bool missed = false;
  double seconds = 0;
};

std::vector<SpeedKnot<double>> speeds(const Kind& kind) {
  if (kind.constant) return {{0, 6}, {60, 6}};
  if (kind.steps) return six_speeds();
  return {{0, 2}, {60, 15}};
}

/// A point of a fit with the true constants of the machine, the true angle and speed.
Vector truth_near(Vector x, const Scene& truth) {
  const Vector exact = point_of(guess_of(truth));
  x.head(machine_constants) = exact.head(machine_constants);
  x[coordinate::phase] += std::remainder(truth.phase - x[coordinate::phase], 2 * std::numbers::pi);
  x[coordinate::speed_factor] = 0;
  return x;
}

Trial trial(Scene truth, const Kind& kind, const Solver& solver, std::uint64_t seed) {
  Random random(seed);
  truth.phase = 2 * std::numbers::pi * uniform(random);
  const KnockRecord record =
      measured_knocks(truth, speeds(kind), kind.sensor,
                      kind.marks ? std::optional(kind.mark_error) : std::nullopt, random);
  const Scene guess = guess_near(truth, random);
  Trial result;
  const double start = processor_seconds();
  try {
    const KnockLoss loss(guess, record);
    const IdentifiedMachine machine = identify(loss, solver, 18);
    for (const std::string& sentence : machine.contradictions) {
      fmt::print(stderr, "trial {}: {}\n", seed, sentence);
    }
    result.refused = !machine.contradictions.empty();
    result.missed = loss.at(truth_near(machine.fit.x, truth), 0) < machine.fit.loss;
    std::vector<Estimate> estimates = machine.constants;
    std::vector<double> truths = {truth.restitution_lower, truth.friction,
                                  truth.wall_upper - truth.wall_lower};
    if (machine.safe_speed) {
      estimates.push_back(*machine.safe_speed);
      truths.push_back(*safe_speed(truth));
    }
    for (std::size_t i = 0; i < estimates.size(); ++i) {
      const Estimate& e = estimates[i];
      const double score = std::log(e.value / truths[i]) / std::log(e.upper / e.lower) * 3.92;
      result.found.push_back(
          {e.value / truths[i] - 1, score, e.lower <= truths[i] && truths[i] <= e.upper});
      if (std::abs(score) < outlying) continue;
      fmt::print(stderr, "trial {}: number {} is {:.1f} deviations off{}\n", seed, i + 1, score,
                 result.missed ? "; the truth explains more" : "");
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "trial {}: {}\n", seed, error.what());
    result.failed = true;
  }
  result.seconds = processor_seconds() - start;
  return result;
}

void print(const std::vector<Trial>& trials) {
  fmt::print("{:<12} {:>6} {:>16} {:>10} {:>10} {:>10} {:>17} {:>8}\n", "", "trials", "covered [%]",
             "within 2 %", "within 1 %", "error [%]", "bias [%]", "score");
  const char* names[] = {"restitution", "friction", "clearance", "safe speed"};
  for (std::size_t i = 0; i < 4; ++i) {
    double n = 0, covered = 0, near = 0, nearer = 0, squares = 0, scores = 0, sum = 0;
    for (const Trial& t : trials) {
      if (t.refused || t.found.size() <= i) continue;
      const auto& [error, score, held] = t.found[i];
      ++n;
      covered += held;
      near += std::abs(error) <= 0.02;
      nearer += std::abs(error) <= 0.01;
      sum += error;
      squares += error * error;
      scores += score * score;
    }
    if (n == 0) continue;
    const double share = covered / n;
    fmt::print(
        "{:<12} {:>6} {:>8.1f} +- {:<4.1f} {:>10.1f} {:>10.1f} {:>10.3f} {:>8.3f} +- {:<5.3f} "
        "{:>8.2f}\n",
        names[i], n, 100 * share, 196 * std::sqrt(share * (1 - share) / n), 100 * near / n,
        100 * nearer / n, 100 * std::sqrt(squares / n), 100 * sum / n,
        196 * std::sqrt(std::max(squares - sum * sum / n, 0.0)) / n, std::sqrt(scores / n));
  }
  std::vector<double> times;
  for (const Trial& t : trials) times.push_back(t.seconds);
  std::ranges::sort(times);
  const auto failed = std::ranges::count_if(trials, &Trial::failed);
  const auto missed = std::ranges::count_if(trials, &Trial::missed);
  fmt::print(
      "{} failed; {} refused; {} explain less than the truth does; processor time of a trial: "
      "median {:.2f} s, "
      "longest {:.2f} s\n",
      failed, std::ranges::count_if(trials, &Trial::refused), missed, times[times.size() / 2],
      times.back());
}

void write_record(Scene truth, const std::string& folder) {
  Random random(7);
  truth.phase = 1;
  const auto speed = speeds({});
  const KnockRecord record =
      synthetic_knocks(truth, speed, {.strengths = true, .mark_jitter = 1e-3}, random);
  std::string knocks = "# Synthetic: simulated knocks, with errors of the sensor.\ntime,strength\n";
  for (const Knock& knock : record.knocks) {
    knocks += fmt::format("{:.4f},{:.4g}\n", knock.time, *knock.strength);
  }
  write_text_file(folder + "/knocks.csv", knocks);
  std::string rows = "time,omega\n";
  for (const SpeedKnot<double>& knot : speed) rows += fmt::format("{},{}\n", knot.time, knot.omega);
  write_text_file(folder + "/speed.csv", rows);
  rows = "# Synthetic: when a mark on the plate passed, at alpha = 0.\ntime\n";
  for (const double time : mark_times(truth, record, 1e-3, random)) {
    rows += fmt::format("{:.4f}\n", time);
  }
  write_text_file(folder + "/marks.csv", rows);
}

int run(const std::vector<std::string>& arguments) {
  const Scene truth = read_scene(arguments.at(0));
  const int trials = std::atoi(arguments.at(1).c_str());
  if (trials == 0) {
    write_record(truth, arguments[1]);
    return 0;
  }
  const auto argument = [&](std::size_t i, const std::string& otherwise) {
    return arguments.size() > i ? arguments[i] : otherwise;
  };
  const std::string name = argument(3, "marks");
  const auto has = [&](const char* part) { return name.find(part) != std::string::npos; };
  Kind kind{has("marks"), has("constant"), has("steps")};
  kind.sensor.strengths = has("strengths");
  for (const auto& [fault, apply] : faults) {
    if (has(fault.c_str())) apply(kind);
  }
  const Solver solver = solver_named(argument(4, usual_solver));
  const auto first = static_cast<std::uint64_t>(std::stoll(argument(5, "1")));
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(std::stoi(argument(2, "1"))));
  std::vector<Trial> results(static_cast<std::size_t>(trials));
  tbb::parallel_for(std::size_t{0}, results.size(),
                    [&](std::size_t k) { results[k] = trial(truth, kind, solver, first + k); });
  print(results);
  return 0;
}

}  // namespace
}  // namespace ricochet::studies::identification

int main(int argc, char** argv) {
  return ricochet::studies::identification::run({argv + 1, argv + argc});
}
