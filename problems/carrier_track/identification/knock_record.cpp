#include "problems/carrier_track/identification/knock_record.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "problems/carrier_track/scene/scene_fields.h"
#include "ricochet/error.h"
#include "ricochet/machine.h"
#include "src/core/csv.h"

namespace ricochet::carrier_track::inline identification {

namespace {

constexpr double turn = 2 * std::numbers::pi;

}  // namespace

double speed_at(const std::vector<SpeedKnot<double>>& speed, double time) {
  const auto after = std::ranges::lower_bound(speed, time, {}, &SpeedKnot<double>::time);
  if (after == speed.begin()) return speed.front().omega;
  if (after == speed.end()) return speed.back().omega;
  const SpeedKnot<double>& before = *std::prev(after);
  const double share = (time - before.time) / (after->time - before.time);
  return before.omega + share * (after->omega - before.omega);
}

double angle_between(const std::vector<SpeedKnot<double>>& speed, double from, double to) {
  double angle = 0;
  double time = from;
  double omega = speed_at(speed, from);
  const auto go_to = [&](double end) {
    const double then = speed_at(speed, end);
    angle += (end - time) * (omega + then) / 2;
    time = end;
    omega = then;
  };
  auto knot = std::ranges::upper_bound(speed, from, {}, &SpeedKnot<double>::time);
  for (; knot != speed.end() && knot->time < to; ++knot) go_to(knot->time);
  go_to(to);
  return angle;
}

PlateMeasurement plate_measurement(const KnockRecord& record, const std::vector<double>& marks,
                                   double mark_angle, double angle_deviation) {
  const auto n = static_cast<Eigen::Index>(marks.size());
  Matrix design(n, 3);
  Vector alpha(n);
  const double first = marks.front();
  double turned = first >= record.from ? angle_between(record.speed, record.from, first)
                                       : -angle_between(record.speed, first, record.from);
  for (Eigen::Index i = 0; i < n; ++i) {
    const double time = marks[static_cast<std::size_t>(i)];
    const double since_last =
        i == 0 ? 0 : angle_between(record.speed, marks[static_cast<std::size_t>(i - 1)], time);
    const double turns = std::max(i == 0 ? 0.0 : 1.0, std::round(since_last / turn));
    turned += since_last;
    design.row(i) << 1, turned, -speed_at(record.speed, time);
    alpha[i] = (i == 0 ? mark_angle : alpha[i - 1]) + turn * turns;
  }
  Vector line = Vector::Zero(3);
  line.head(2) = design.leftCols(2).colPivHouseholderQr().solve(alpha);
  const auto variance = [&] {
    const double squares = (alpha - design * line).squaredNorm();
    return std::max(squares / static_cast<double>(n - 2), 1e-12);
  };
  double of_mark = variance();
  if (record.lag_deviation > 0) {
    // The lag is one more measurement of the line: 0, in units of a mark's deviation.
    constexpr int rounds = 5;  // the variance is that about the line with the lag
    for (int round = 0; round < rounds; ++round) {
      Matrix rows(n + 1, 3);
      rows << design, 0, 0, std::sqrt(of_mark) / record.lag_deviation;
      Vector right(n + 1);
      right << alpha, 0;
      line = rows.colPivHouseholderQr().solve(right);
      of_mark = variance();
    }
  }
  // The second unknown is a logarithm: its slope is the factor itself.
  design.col(1) *= line[1];
  Matrix information = design.leftCols(2).transpose() * design.leftCols(2) / of_mark;
  if (record.lag_deviation > 0) {
    const Vector with_lag = design.leftCols(2).transpose() * design.col(2) / of_mark;
    const double of_lag =
        design.col(2).squaredNorm() / of_mark + 1 / (record.lag_deviation * record.lag_deviation);
    information -= with_lag * with_lag.transpose() / of_lag;
  }
  // An unknown angle of the mark: (information^-1 + variance of the phase)^-1.
  const Vector of_phase = information.col(0);
  const double spread = angle_deviation * angle_deviation;
  information -= of_phase * of_phase.transpose() * (spread / (1 + spread * of_phase[0]));
  return {line[0], std::log(line[1]), information, std::sqrt(of_mark)};
}

namespace {

constexpr double most_turns = 10'000;

void check_times(const CsvTable& table, double gap) {
  const std::vector<double>& times = table.column("time");
  table.require(
      "time", [](auto, double t) { return std::abs(t) <= 1e12; }, "within +-1e12 s");
  table.require(
      "time", [&](std::size_t i, double t) { return i == 0 || t >= times[i - 1] + gap; },
      gap > 0 ? "later than the one before by at least 1e-6 s" : "no earlier than the one before");
}

void check_speeds(const CsvTable& table) {
  table.require(
      "omega", [](auto, double omega) { return omega >= 0 && omega <= fastest_frequency; },
      "within 0..1e9 rad/s");
}

constexpr double shortest_gap = 1e-6;  // [s], between speeds

std::vector<SpeedKnot<double>> speeds_of(const CsvTable& table) {
  const std::vector<double>& times = table.column("time");
  const std::vector<double>& speeds = table.column("omega");
  std::vector<SpeedKnot<double>> result;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!result.empty() && times[i] < result.back().time + shortest_gap) continue;
    result.push_back({times[i], speeds[i]});
  }
  return result;
}

std::vector<SpeedKnot<double>> speed_of(const KnockFiles& files, const CsvTable& knocks) {
  const bool in_knocks = knocks.find("omega") != nullptr;
  const int sources = (files.omega ? 1 : 0) + (files.speed.empty() ? 0 : 1) + (in_knocks ? 1 : 0);
  if (sources != 1) {
    throw InputError(
        fmt::format("{}: the speed of the plate must come from {} --omega, --speed "
                    "FILE and the column omega",
                    files.knocks, sources == 0 ? "one of" : "only one of"));
  }
  if (files.omega) {
    if (!(*files.omega > 0 && *files.omega <= fastest_frequency)) {
      throw InputError(fmt::format("--omega {}: must be > 0 and at most 1e9 rad/s", *files.omega));
    }
    return {{knocks.column("time").front(), *files.omega}};
  }
  if (in_knocks) {
    check_speeds(knocks);
    return speeds_of(knocks);
  }
  const CsvTable table = read_csv_table(files.speed, {"time", "omega"});
  check_times(table, shortest_gap);
  check_speeds(table);
  return speeds_of(table);
}

/// What a speed in another unit would be: `factor` is the speed as recorded over that in rad/s.
std::string unit_of(double factor) {
  struct Unit {
    double factor;
    const char* name;
  };
  constexpr double turn = 2 * std::numbers::pi;
  constexpr Unit units[] = {
      {60 / turn, "rpm"}, {1 / turn, "turns per second"}, {360 / turn, "degrees per second"}};
  for (const Unit& unit : units) {
    if (std::abs(std::log(factor / unit.factor)) < 0.1) {
      return fmt::format(": are the speeds in {}, not in rad/s?", unit.name);
    }
  }
  return factor > 0.4 && factor < 0.6 ? ": are there two marks on the plate?"
                                      : ": are the speeds in rad/s?";
}

/// Most turns between marks may miss one or two; none may be far from a whole turn.
void check_marks(const KnockFiles& files, const KnockRecord& record,
                 const std::vector<double>& marks) {
  std::vector<double> turns;
  for (std::size_t i = 1; i < marks.size(); ++i) {
    turns.push_back(angle_between(record.speed, marks[i - 1], marks[i]) / (2 * std::numbers::pi));
  }
  std::ranges::nth_element(turns, turns.begin() + static_cast<std::ptrdiff_t>(turns.size() / 2));
  const double turn = turns[turns.size() / 2];
  const double whole = std::clamp(std::round(turn), 1.0, 3.0);
  if (std::abs(turn / whole - 1) <= 0.15) return;
  throw InputError(
      fmt::format("{}: from mark to mark the plate makes {:.3g} turns by its speeds: must be "
                  "within 0.85..1.15{}",
                  files.marks, turn, unit_of(turn)));
}

/// Of the shorter of two files at least half must be within the times of the other.
void check_overlap(const KnockFiles& files, const std::vector<double>& knocks,
                   const std::string& other, double from, double to) {
  const double both = std::min(to, knocks.back()) - std::max(from, knocks.front());
  if (both >= std::min(to - from, knocks.back() - knocks.front()) / 2) return;
  throw InputError(fmt::format(
      "{}: the knocks ({:.6g} to {:.6g} s) and {} ({:.6g} to {:.6g} s) have {:.4g} s in common: "
      "must be at least half of the shorter one: do the clocks differ?",
      files.knocks, knocks.front(), knocks.back(), other, from, to, std::max(both, 0.0)));
}

void check_deviations(const KnockFiles& files) {
  if (!(files.mark_deviation >= 0 && files.mark_deviation <= 0.5)) {
    throw InputError(
        fmt::format("--mark-deviation {}: must be within 0..0.5 rad", files.mark_deviation));
  }
  if (!(files.lag_deviation >= 0 && files.lag_deviation <= 0.1)) {
    throw InputError(
        fmt::format("--lag-deviation {}: must be within 0..0.1 s", files.lag_deviation));
  }
}

void add_marks(const KnockFiles& files, KnockRecord& record, const std::vector<double>& marks) {
  if (!std::isfinite(files.mark_angle)) throw InputError("--mark-angle: must be a finite number");
  if (marks.size() < 3) throw InputError(files.marks + ": must have at least three marks");
  check_marks(files, record, marks);
  record.plate = plate_measurement(record, marks, files.mark_angle, files.mark_deviation);
}

void check_turns(const KnockFiles& files, const KnockRecord& record) {
  const double turns = angle_between(record.speed, record.from, record.to) / (2 * std::numbers::pi);
  if (turns >= 2 && turns <= most_turns) return;
  throw InputError(fmt::format("{}: the plate makes {:.3g} turns in {:.4g} s: must be 2 to 10000",
                               files.knocks, turns, record.duration()));
}

/// A carrier that is thrown knocks at least twice a turn.
void check_knocks_a_turn(const KnockFiles& files, const KnockRecord& record,
                         const std::vector<double>& knocks) {
  constexpr double fewest = 1;
  const double turns =
      angle_between(record.speed, knocks.front(), knocks.back()) / (2 * std::numbers::pi);
  const double a_turn = static_cast<double>(knocks.size()) / turns;
  if (a_turn >= fewest) return;
  throw InputError(fmt::format(
      "{}: {} knocks in {:.4g} turns of the plate are {:.2g} a turn: must be at least {}: are the "
      "speeds of {} in rad/s, not in rpm or degrees per second? Leave out times without knocks",
      files.knocks, knocks.size(), turns, a_turn, fewest,
      files.omega ? "--omega" : (files.speed.empty() ? files.knocks : files.speed)));
}

}  // namespace

KnockRecord read_knock_record(const KnockFiles& files) {
  check_deviations(files);
  const CsvTable table = read_csv_table(files.knocks, {"time", "strength", "omega"});
  check_times(table, 0);
  const std::vector<double>& times = table.column("time");
  if (times.size() < fewest_knocks) {
    throw InputError(fmt::format("{}: {} knocks: must have at least {}", files.knocks, times.size(),
                                 fewest_knocks));
  }
  const std::vector<double>* strengths = table.find("strength");
  if (strengths != nullptr) {
    table.require(
        "strength", [](auto, double x) { return x > 0; }, "> 0");
  }
  KnockRecord record;
  record.lag_deviation = files.lag_deviation;
  for (std::size_t i = 0; i < times.size(); ++i) {
    record.knocks.push_back({times[i]});
    if (strengths != nullptr) record.knocks.back().strength = (*strengths)[i];
  }
  record.speed = speed_of(files, table);
  record.from = std::min(times.front(), record.speed.front().time);
  record.to = std::max(times.back(), record.speed.back().time);
  if (record.speed.size() > 1) {
    check_overlap(files, times, files.speed.empty() ? files.knocks : files.speed,
                  record.speed.front().time, record.speed.back().time);
  }
  std::vector<double> marks;
  if (!files.marks.empty()) {
    const CsvTable marked = read_csv_table(files.marks, {"time"});
    check_times(marked, shortest_gap);
    marks = marked.column("time");
    check_overlap(files, times, files.marks, marks.front(), marks.back());
    record.from = std::min(record.from, marks.front());
    record.to = std::max(record.to, marks.back());
  }
  check_turns(files, record);
  if (!files.marks.empty()) add_marks(files, record, marks);
  check_knocks_a_turn(files, record, times);
  take_out_sensor_faults(record);
  if (record.knocks.size() < fewest_knocks) {
    throw InputError(
        fmt::format("{}: {} knocks without echoes and rows at one time: must have at "
                    "least {}",
                    files.knocks, record.knocks.size(), fewest_knocks));
  }
  return record;
}

void check_identifiable(const Scene& scene, const std::string& origin) {
  const auto require = [&](bool holds, const char* key, const char* demand) {
    if (!holds) throw InputError(fmt::format("{}: {}: must be {}", origin, key, demand));
  };
  require(scene.fidelity == Fidelity::impact, "model.fidelity",
          "impact: only it carries derivatives");
  require(scene.restitution_lower == scene.restitution_upper, "scene.restitution",
          "the same for both walls: knocks identify one");
  require(std::isfinite(scene.wall_upper), "scene.wall_upper", "finite");
  require(scene.friction > 0 && scene.normal_force > 0, "scene.friction",
          "> 0, and so must scene.normal_force: friction sets when the carrier leaves a wall");
  require(scene.centrifugal_mass_radius > 0, "scene.centrifugal_mass_radius",
          "> 0: it throws the carrier");
  require(scene.disturbance == 0, "scene.disturbance", "0: its phase in a record is not known");
}

std::optional<double> safe_speed(const Scene& scene, double fastest) {
  Scene from_rest = at_speed(scene, fastest);
  from_rest.start_position = scene.wall_lower;
  from_rest.start_velocity = 0;
  const auto quiet = quiet_up_to(from_rest, quiet_per_turn, {fastest / 200, fastest});
  return quiet && *quiet < fastest ? quiet : std::nullopt;
}

}  // namespace ricochet::carrier_track::inline identification
