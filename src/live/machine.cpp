// The border of the WebAssembly module: plain functions over one machine. Numbers come in by
// `room`, and go out by `results`; texts go out by `text`. A C++ exception ends the instance, see
// module/platform/exceptions.cpp: the caller makes a new one.
#include "ricochet/machine.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "problems/carrier_track/counting/count.h"
#include "problems/carrier_track/counting/quiet_speed.h"
#include "problems/carrier_track/counting/recording.h"
#include "problems/carrier_track/counting/threshold.h"
#include "problems/carrier_track/suite/cases.h"
#include "problems/carrier_track/suite/speed_problems.h"
#include "ricochet/error.h"
#include "src/core/names.h"
#include "src/core/progress.h"
#include "src/live/count_there.h"
#include "src/live/flat_scene.h"
#include "src/live/machine_file.h"
#include "src/live/race.h"

#define RICOCHET_EXPORT(name) __attribute__((export_name(#name)))

namespace ricochet {
namespace {

std::vector<std::string> warnings;  ///< since a file was begun

}  // namespace

/// There is no terminal: who reads the file tells them.
void warn(const std::string& text) {
  warnings.push_back(text);
}

}  // namespace ricochet

namespace ricochet::live {
namespace {

using namespace carrier_track;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

Scene machine;
std::vector<double> given, told_numbers;
std::string given_text, told_text;

void tell(std::optional<double> x) {
  told_numbers.push_back(x.value_or(missing));
}

void tell_line(const std::vector<std::string>& cells) {
  for (const std::string& cell : cells) {
    told_text += cell;
    told_text += &cell == &cells.back() ? '\n' : '\t';
  }
}

}  // namespace

/// Room for so many numbers, or bytes of a text.
RICOCHET_EXPORT(room) double* room(int size) {
  given.resize(static_cast<std::size_t>(size));
  return given.data();
}
RICOCHET_EXPORT(text_room) char* text_room(int size) {
  given_text.resize(static_cast<std::size_t>(size));
  return given_text.data();
}

RICOCHET_EXPORT(results) const double* results() {
  return told_numbers.data();
}
RICOCHET_EXPORT(results_size) int results_size() {
  return static_cast<int>(told_numbers.size());
}
RICOCHET_EXPORT(text) const char* text() {
  return told_text.data();
}
RICOCHET_EXPORT(text_size) int text_size() {
  return static_cast<int>(told_text.size());
}

/// Text: a line for each number of a scene, in the order of the numbers: table, key, unit, remark,
/// range, choices with a bar between them, "required" if a file must have it. Numbers: of a scene
/// of which nothing is given.
RICOCHET_EXPORT(fields) void fields() {
  told_text.clear();
  for (const FlatField& field : flat_fields()) {
    std::string choices;
    for (const std::string& choice : field.choices)
      choices += (choices.empty() ? "" : "|") + choice;
    tell_line({field.table, field.key, field.unit, field.remark, field.range, choices,
               field.required ? "required" : ""});
  }
  told_numbers = numbers_of(Scene{});
}

/// Text: the ids of the paper's cases; numbers: restitution, friction, disturbance [N], the paper's
/// threshold [rad/s] and quiet count of each, NaN where it has none.
RICOCHET_EXPORT(cases) void cases() {
  told_text.clear();
  told_numbers.clear();
  for (const Case& one : all_cases()) {
    tell_line({one.id});
    tell(one.restitution);
    tell(one.friction);
    tell(one.disturbance);
    tell(one.claim.threshold);
    tell(one.claim.quiet_count);
  }
}

/// A number [unit] from a text with a unit in the room, NaN if it is none; the unit follows the
/// text's first `size` bytes.
RICOCHET_EXPORT(quantity) double quantity_in(int size) {
  const std::size_t at = static_cast<std::size_t>(size);
  return quantity(given_text.substr(0, at), given_text.substr(at)).value_or(missing);
}

/// Numbers: of the machine file in the room, whose name is the text's first `size` bytes. Text:
/// what to know of it, a line each.
RICOCHET_EXPORT(read_machine_file) void read_machine_file(int size) {
  const std::size_t at = static_cast<std::size_t>(size);
  warnings.clear();
  const MachineFile file = machine_file(given_text.substr(at), given_text.substr(0, at));
  told_numbers = file.numbers;
  told_text.clear();
  for (const std::string& warning : warnings) tell_line({one_line(warning)});
  for (const std::string& note : file.notes) tell_line({note});
}

/// Text: the machine as a file.
RICOCHET_EXPORT(write_machine_file) void write_machine_file() {
  told_text = write_scene(machine);
}

/// The machine becomes that of the numbers in the room.
RICOCHET_EXPORT(set_scene) void set_scene() {
  machine = scene_of(given);
}

/// Numbers: the collision counts at first, first + step, ... [rad/s], `size` of them.
RICOCHET_EXPORT(counts) void counts_from(double first, double step, int size) {
  told_numbers.clear();
  Scene there = at_speed(machine, first);
  for (int k = 0; k < size; ++k) {
    there.omega = first + k * step;
    told_numbers.push_back(count_there(there));
  }
}

/// Numbers: the count, whether it is certain, the end of the window [s], the number of impacts; of
/// each its time [s], wall (0 lower, 1 upper), speed [m/s] and whether it counts; then time and
/// position of each sample of the path. Text: why the count is not certain.
RICOCHET_EXPORT(simulate) void simulate_at(double omega, int samples) {
  const Scene there = at_speed(machine, omega);
  const Recording recording = record(there, 0, static_cast<std::size_t>(samples));
  told_text = recording.certainty.reason;
  told_numbers = {static_cast<double>(recording.count), recording.certainty.certain ? 1.0 : 0.0,
                  recording.end.time, static_cast<double>(recording.impacts.size())};
  for (const Impact& impact : recording.impacts) {
    const bool counts = there.rule == CountRule::impacts && impact.speed > 0 &&
                        is_counted(impact.speed, there.counting_limit);
    for (const double x :
         {impact.time, impact.wall == Wall::upper ? 1.0 : 0.0, impact.speed, counts ? 1.0 : 0.0}) {
      told_numbers.push_back(x);
    }
  }
  for (const Sample& sample : recording.path) {
    told_numbers.push_back(sample.time);
    told_numbers.push_back(sample.position);
  }
}

/// Whether the machine's long run is known.
RICOCHET_EXPORT(has_regimes) int has_regimes_now() {
  return has_regimes(machine) ? 1 : 0;
}

/// Numbers: of each regime between two speeds [rad/s]: from, to, mean, least and most collisions a
/// turn, energy a turn [J], fastest impact [m/s] and share of the time at rest at its fast end,
/// turns of a period, whether it is certain. Text: what ends it, a line each.
RICOCHET_EXPORT(regimes) void regimes_between(double from, double to) {
  told_numbers.clear();
  told_text.clear();
  for (const Regime& regime : regimes_of(machine, {from, to})) {
    for (const double x : {regime.from, regime.to, regime.collisions_per_turn,
                           regime.least_per_turn, regime.most_per_turn, regime.last.energy_per_turn,
                           regime.last.fastest_impact, regime.last.share_at_rest,
                           static_cast<double>(regime.turns), regime.certain ? 1.0 : 0.0}) {
      told_numbers.push_back(x);
    }
    tell_line({name_of(regime.ends_by)});
  }
}

/// The paper's rule of a scan, whose counts at step, 2 step, ... [rad/s] are in the room; parts of
/// it use every `stride`-th. `claimed`: the paper's threshold [rad/s], or NaN. Numbers: quiet
/// count, largest quiet count, threshold and first loud speed [rad/s], share misclassified; NaN
/// where there is none.
RICOCHET_EXPORT(window_rule) void window_rule(double step, int stride, double claimed) {
  const SpeedScan scan{step, std::vector<int>(given.begin(), given.end())};
  Claim claim;
  if (!std::isnan(claimed)) claim.threshold = claimed;
  const auto count_at_speed = [](double omega) { return count_there(at_speed(machine, omega)); };
  const Score found = score(count_at_speed, claim, scan, static_cast<std::size_t>(stride));
  told_numbers.clear();
  tell(found.quiet_count);
  tell(std::floor(quiet_limit(found.quiet_count)));
  tell(found.threshold);
  tell(found.first_loud);
  tell(found.misclassified);
}

/// Text: what moves the fastest quiet speed omega [rad/s] of the long run, a key a line, the most
/// effective first; numbers: by how much [%] per 1 % more of each.
RICOCHET_EXPORT(sensitivities) void sensitivities_at(double omega) {
  told_text.clear();
  told_numbers.clear();
  const Limit limit{Measure::collisions_per_turn, quiet_per_turn};
  for (const Sensitivity& one : sensitivities(machine, limit, omega)) {
    tell_line({one.key});
    tell(one.percent);
  }
}

/// The most collisions in the window of quiet speeds, for a machine of which no paper claims
/// anything; `border` [rad/s]: its fastest quiet speed. See quiet_rule_of().
RICOCHET_EXPORT(quiet_limit_below) int quiet_limit_below(double border) {
  return most_collisions_below(machine, border, 1e-3);
}

/// The solution [rad/s] of the race, NaN if there is none; see goal_of().
RICOCHET_EXPORT(race_goal) double race_goal(double quiet_limit, double fastest) {
  return goal_of({machine, quiet_limit, fastest}).value_or(missing);
}

/// Numbers: speed [rad/s], count and value of each evaluation of a racer, see race.h.
RICOCHET_EXPORT(race)
void race_of(int racer, double seed, int evaluations, double quiet_limit, double fastest) {
  const Race race{machine, quiet_limit, fastest, evaluations};
  told_numbers.clear();
  for (const RaceStep& step :
       steps_of(static_cast<Racer>(racer), race, static_cast<std::uint64_t>(seed))) {
    told_numbers.push_back(step.omega);
    told_numbers.push_back(step.count);
    told_numbers.push_back(step.value);
  }
}

}  // namespace ricochet::live
