#include <fmt/format.h>
#include <ricochet/ricochet.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "ricochet/error.h"
#include "ricochet/evaluator.h"
#include "ricochet/machine.h"
#include "ricochet/scene.h"
#include "src/app/interface/interface.h"
#include "src/app/interface/problem_functions.h"

/// The handle of an open machine.
struct ricochet_machine {};

namespace ricochet::interface {

/// A machine opened by an external program, and the results of its last calls.
struct OpenedMachine : ricochet_machine {
  /// Errors name the text `origin`. Throws InputError if it is no valid machine.
  OpenedMachine(std::string machine_text, const std::string& origin)
      : text(std::move(machine_text)), scene(carrier_track::parse_scene(text, origin)) {}

  std::string text;  ///< of its file
  carrier_track::Scene scene;
  carrier_track::Recording recording;  ///< of the last simulation
  std::vector<carrier_track::Regime> regimes;
  std::vector<std::string> regime_ends;  ///< names, one for each regime
};

// What ricochet.h asks of a machine.

namespace {

using namespace carrier_track;

using OpenMachines = OpenHandles<ricochet_machine, OpenedMachine>;

/// All open machines; never destroyed, like open_problems().
OpenMachines& open_machines() {
  static auto& all = *new OpenMachines("machine");
  return all;
}

/// Writes one number of every row to the caller's array, unless it is null.
template <class Row, class Number, class Column>
void write_column(const std::vector<Row>& rows, Number* to, const Column& column) {
  if (!to) return;
  for (const Row& row : rows) *to++ = static_cast<Number>(column(row));
}

Measure measure_named(const std::string& name) {
  const std::array<std::pair<std::string, Measure>, 4> known = {
      {{"collisions", Measure::collisions},
       {"collisions-per-turn", Measure::collisions_per_turn},
       {"energy", Measure::energy},
       {"impact-speed", Measure::impact_speed}}};
  std::vector<std::string> names;
  for (const auto& [each, measure] : known) {
    if (each == name) return measure;
    names.push_back(each);
  }
  throw InputError(fmt::format("measure {}: must be {}", name, fmt::join(names, ", ")));
}

thread_local double limit_seconds = 60;
/// How far the last call of this thread came before that limit; NaN if it was complete.
thread_local double reached = std::numeric_limits<double>::quiet_NaN();

/// Returns what `work` returns under the time limit of this thread. Throws std::runtime_error if
/// that throws TimeLimitReached.
template <class Work>
auto in_time(const Work& work) {
  reached = std::numeric_limits<double>::quiet_NaN();
  const TimeLimit limit(limit_seconds);
  try {
    return work();
  } catch (const TimeLimitReached&) {
    throw std::runtime_error(fmt::format(
        "the time limit of {} s was reached; ricochet_limit_seconds sets another", limit_seconds));
  }
}

std::int64_t size_of(const auto& list) {
  return static_cast<std::int64_t>(list.size());
}

}  // namespace

}  // namespace ricochet::interface

using namespace ricochet::interface;
using ricochet::InputError;

RICOCHET_EXPORTED ricochet_machine* ricochet_open_machine(const char* file) {
  ricochet_machine* opened = nullptr;
  succeeds([&] {
    const std::string name = file ? file : "";
    opened = open_machines().add(std::make_unique<OpenedMachine>(scene_text(name), name));
  });
  return opened;
}

RICOCHET_EXPORTED ricochet_machine* ricochet_parse_machine(const char* text) {
  ricochet_machine* opened = nullptr;
  succeeds([&] {
    if (!text) throw InputError("the text of the machine is NULL");
    opened = open_machines().add(std::make_unique<OpenedMachine>(text, "text"));
  });
  return opened;
}

RICOCHET_EXPORTED void ricochet_close_machine(ricochet_machine* machine) {
  if (machine) succeeds([&] { open_machines().close(machine); });
}

RICOCHET_EXPORTED const char* ricochet_machine_text(const ricochet_machine* machine) {
  return open_machines().ask<const char*>(machine, nullptr,
                                          [](OpenedMachine& at) { return at.text.c_str(); });
}

RICOCHET_EXPORTED double ricochet_machine_speed(const ricochet_machine* machine) {
  return open_machines().ask(
      machine, std::numeric_limits<double>::quiet_NaN(), [](OpenedMachine& at) {
        return at.scene.profile.empty() ? at.scene.omega : std::numeric_limits<double>::quiet_NaN();
      });
}

RICOCHET_EXPORTED std::int32_t ricochet_limit_seconds(double seconds) {
  return succeeds([&] {
    if (!(seconds > 0)) throw InputError(fmt::format("seconds {}: must be > 0", seconds));
    limit_seconds = seconds;
  })
             ? 0
             : 1;
}

RICOCHET_EXPORTED double ricochet_reached(void) {
  return reached;
}

RICOCHET_EXPORTED std::int32_t ricochet_simulate(ricochet_machine* machine, double omega,
                                                 std::int64_t samples, std::int32_t* count,
                                                 std::int32_t* certain) {
  return open_machines().ask(machine, 1, [&](OpenedMachine& at) {
    if (samples < 0) throw InputError(fmt::format("samples {}: must be >= 0", samples));
    at.recording = in_time([&] {
      return simulate(std::isnan(omega) ? at.scene : at_speed(at.scene, omega), default_smoothing,
                      static_cast<std::size_t>(samples));
    });
    if (at.recording.certainty.doubt == Doubt::unfinished) reached = at.recording.end.time;
    if (count) *count = at.recording.count;
    if (certain) *certain = at.recording.certainty.certain ? 1 : 0;
    return 0;
  });
}

RICOCHET_EXPORTED const char* ricochet_doubt(const ricochet_machine* machine) {
  return open_machines().ask<const char*>(
      machine, nullptr, [](OpenedMachine& at) { return at.recording.certainty.reason.c_str(); });
}

RICOCHET_EXPORTED std::int64_t ricochet_impacts(const ricochet_machine* machine, double* times,
                                                double* speeds, std::int32_t* walls) {
  return open_machines().ask(machine, std::int64_t{-1}, [&](OpenedMachine& at) {
    const auto& impacts = at.recording.impacts;
    write_column(impacts, times, [](const Impact& impact) { return impact.time; });
    write_column(impacts, speeds, [](const Impact& impact) { return impact.speed; });
    write_column(impacts, walls, [](const Impact& impact) { return impact.wall == Wall::upper; });
    return size_of(impacts);
  });
}

RICOCHET_EXPORTED std::int64_t ricochet_path(const ricochet_machine* machine, double* times,
                                             double* positions, double* velocities) {
  return open_machines().ask(machine, std::int64_t{-1}, [&](OpenedMachine& at) {
    const auto& path = at.recording.path;
    write_column(path, times, [](const Sample& sample) { return sample.time; });
    write_column(path, positions, [](const Sample& sample) { return sample.position; });
    write_column(path, velocities, [](const Sample& sample) { return sample.velocity; });
    return size_of(path);
  });
}

RICOCHET_EXPORTED std::int32_t ricochet_counts(const ricochet_machine* machine,
                                               const double* speeds, std::int64_t size,
                                               std::int32_t* found) {
  return open_machines().ask(machine, 1, [&](OpenedMachine& at) {
    if (size < 0) throw InputError(fmt::format("{} speeds: must be >= 0", size));
    if (size > 0 && !(speeds && found)) throw InputError("the speeds or the counts are NULL");
    const std::vector<int> all = in_time(
        [&] { return counts(at.scene, std::span(speeds, static_cast<std::size_t>(size))); });
    std::ranges::copy(all, found);
    return 0;
  });
}

RICOCHET_EXPORTED std::int64_t ricochet_regimes(ricochet_machine* machine, double from, double to) {
  return open_machines().ask(machine, std::int64_t{-1}, [&](OpenedMachine& at) {
    at.regimes = in_time([&] { return regimes_of(at.scene, {from, to}); });
    const Regime& last = at.regimes.back();
    if (last.ends_by == RegimeEnd::time_limit) reached = last.to;
    at.regime_ends.clear();
    for (const Regime& regime : at.regimes) at.regime_ends.push_back(name_of(regime.ends_by));
    return size_of(at.regimes);
  });
}

RICOCHET_EXPORTED std::int64_t ricochet_regime_table(const ricochet_machine* machine, double* from,
                                                     double* to, double* mean_per_turn,
                                                     double* least_per_turn, double* most_per_turn,
                                                     std::int32_t* turns, std::int32_t* rests,
                                                     std::int32_t* certain) {
  return open_machines().ask(machine, std::int64_t{-1}, [&](OpenedMachine& at) {
    const auto tell = [&](auto* column, auto member) {
      write_column(at.regimes, column, [&](const Regime& regime) { return regime.*member; });
    };
    tell(from, &Regime::from);
    tell(to, &Regime::to);
    tell(mean_per_turn, &Regime::collisions_per_turn);
    tell(least_per_turn, &Regime::least_per_turn);
    tell(most_per_turn, &Regime::most_per_turn);
    tell(turns, &Regime::turns);
    tell(rests, &Regime::rests);
    tell(certain, &Regime::certain);
    return size_of(at.regimes);
  });
}

RICOCHET_EXPORTED const char* ricochet_regime_end(const ricochet_machine* machine,
                                                  std::int64_t index) {
  return open_machines().ask<const char*>(machine, nullptr, [&](OpenedMachine& at) {
    if (index < 0 || index >= size_of(at.regime_ends)) {
      throw InputError(fmt::format("regime {}: there are {}", index, at.regime_ends.size()));
    }
    return at.regime_ends[static_cast<std::size_t>(index)].c_str();
  });
}

RICOCHET_EXPORTED std::int32_t ricochet_quiet_speed(const ricochet_machine* machine,
                                                    const char* measure, double at_most,
                                                    double fastest, double* quiet,
                                                    double* first_loud, double* limit) {
  return open_machines().ask(machine, 1, [&](OpenedMachine& at) {
    QuietSpeedOptions options;
    if (measure) options.limit = Limit{measure_named(measure), at_most};
    if (!std::isnan(fastest)) options.fastest = fastest;
    const QuietSpeed answer = in_time([&] { return quiet_speed(at.scene, options); });
    if (answer.reached) reached = *answer.reached;
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (quiet) *quiet = answer.fastest_quiet.value_or(none);
    if (first_loud) *first_loud = answer.split.first_loud.value_or(none);
    if (limit) *limit = answer.limit ? answer.limit->at_most : none;
    return 0;
  });
}
