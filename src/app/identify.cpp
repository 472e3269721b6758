#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "problems/carrier_track/identification/knock_record.h"
#include "ricochet/error.h"
#include "ricochet/solver.h"
#include "src/app/command_line.h"
#include "src/app/report.h"
#include "src/app/scene_choice.h"
#include "src/identification/identified_machine.h"
#include "src/identification/knock_fit.h"
#include "src/report/drawing.h"
#include "src/report/json.h"
#include "src/report/text.h"

namespace ricochet::cli {
namespace {

using namespace carrier_track;
using namespace studies::identification;
using report::Json;

struct IdentifyOptions {
  carrier_track::KnockFiles files;
  std::string scene_file;
  std::string solver = studies::identification::usual_solver;
  double fastest = 18;   ///< [rad/s], end of the range of speeds
  double seconds = 300;  ///< time limit
  bool json = false;
  std::string out;   ///< machine file (TOML) with the fitted constants; empty: none
  std::string plot;  ///< SVG file of residuals; empty: none
};

const std::vector<std::string> held_fixed = {
    "mass",          "normal_force", "pull", "centrifugal_mass_radius", "slider_mass_radius",
    "counting_limit"};

/// Without `trusted` there is no interval.
Json json_of(const Estimate& e, bool trusted) {
  Json json = {{"name", e.name},
               {"unit", e.unit},
               {"value", e.value},
               {"lower", trusted ? Json(e.lower) : Json()},
               {"upper", trusted ? Json(e.upper) : Json()}};
  if (e.assumed) json["in_file"] = *e.assumed;
  return json;
}

Json json_of(const IdentifiedMachine& machine, const KnockLoss& loss, const std::string& solver) {
  const KnockUnknowns found = unknowns_at(machine.fit.x);
  Json correlations = Json::array();
  for (Eigen::Index i = 0; i < machine_constants; ++i) {
    const Vector row = machine.correlations.row(i);
    correlations.push_back(std::vector<double>(row.begin(), row.end()));
  }
  Json next;
  if (machine.next) {
    next = {{"omega", machine.next->omega},
            {"seconds", next_step_seconds},
            {"target", machine.next_target},
            {"relative_deviation_now", machine.next->now},
            {"relative_deviation_then", machine.next->deviation}};
  }
  const bool trusted = is_trusted(machine);
  return {{"knocks", loss.record().knocks.size()},
          {"seconds", loss.record().duration()},
          {"constants", report::list_of(machine.constants,
                                        [&](const Estimate& e) { return json_of(e, trusted); })},
          {"safe_speed", machine.safe_speed ? json_of(*machine.safe_speed, trusted) : Json()},
          {"correlations", machine.complete ? correlations : Json()},
          {"sensor",
           {{"jitter", found.jitter},
            {"missed_share", machine.missed_share},
            {"spurious_share", 1 - machine.explained_share},
            {"lag", found.lag},
            {"drift", found.drift},
            {"dead_time", loss.record().dead_time},
            {"detection_limit", found.detection_limit / found.gain}}},
          {"plate",
           {{"marks", loss.record().plate.has_value()},
            {"phase", found.phase},
            {"speed_factor", found.speed_factor}}},
          {"complete", machine.complete},
          {"contradictions", machine.contradictions},
          {"remarks", machine.remarks},
          {"next_speed", next},
          {"held_fixed", held_fixed},
          {"solver", solver},
          {"loss", machine.fit.loss},
          {"evaluations", machine.fit.evaluations}};
}

void print_estimate(const Estimate& e, double unit, const std::string& unit_name, bool trusted) {
  fmt::print("  {:<12} {:>9.4g} {:<5}  {}{}\n", e.name, e.value / unit, unit_name,
             trusted ? fmt::format("95 %: {:.4g} to {:.4g}", e.lower / unit, e.upper / unit)
                     : "no interval",
             e.assumed ? fmt::format("  (file: {:.4g})", *e.assumed / unit) : "");
}

void print_machine(const IdentifiedMachine& machine, const KnockLoss& loss, const std::string& name,
                   const std::string& solver) {
  const KnockRecord& record = loss.record();
  const KnockUnknowns found = unknowns_at(machine.fit.x);
  fmt::print("{}: fitted to {} in {:.4g} s, {} strengths, the plate's angle {}\n", name,
             report::counted(record.knocks.size(), "knock"), record.duration(),
             record.has_strengths() ? "with" : "without",
             record.plate ? "known from marks" : "unknown");
  const bool trusted = is_trusted(machine);
  for (const std::string& sentence : machine.contradictions) fmt::print("{}\n", sentence);
  if (!machine.contradictions.empty()) {
    fmt::print("The values below are the best fit of a model that does not hold:\n");
  }
  for (const Estimate& e : machine.constants) {
    const bool is_length = e.unit == "m";
    print_estimate(e, is_length ? 1e-3 : 1, is_length ? "mm" : "", trusted);
  }
  if (machine.safe_speed) {
    print_estimate(*machine.safe_speed, 1, "rad/s", trusted);
    fmt::print("Safe speed: the fastest with at most two collisions a turn in steady motion.\n");
  } else if (machine.complete) {
    fmt::print(
        "No safe speed: every speed of the range is safe, or its slowest is not, or the border is "
        "out of reach.\n");
  }
  fmt::print(
      "Sensor: jitter {:.2g} ms; {:.1f} % of the impacts missed, {:.1f} % of the knocks "
      "spurious; it detects impacts from {:.2g} mm/s on.\n",
      1e3 * found.jitter, 100 * machine.missed_share, 100 * (1 - machine.explained_share),
      1e3 * found.detection_limit / found.gain);
  if (record.lag_deviation > 0) {
    fmt::print("Clock of the knocks: {:.2g} ms late, {:.0f} ppm fast, as fitted.\n",
               1e3 * found.lag, 1e6 * found.drift);
  }
  for (const std::string& remark : machine.remarks) fmt::print("Note: {}\n", remark);
  if (machine.next && trusted) {
    fmt::print(
        "Record next: {:.3g} rad/s for {:.0f} s. The standard deviation of the {} would "
        "fall from {:.2g} % to {:.2g} %.\n",
        machine.next->omega, next_step_seconds, machine.next_target, 100 * machine.next->now,
        100 * machine.next->deviation);
  }
  fmt::print("Held as in the file: {}.\n", fmt::join(held_fixed, ", "));
  fmt::print("Solver {}: {} of the record.\n", solver,
             report::counted(machine.fit.evaluations, "simulation"));
}

std::string machine_text(const IdentifiedMachine& machine, const std::string& knocks) {
  return fmt::format("# Restitution, friction and clearance are fitted to the knocks of {}.\n{}{}",
                     std::filesystem::path(knocks).filename().string(),
                     is_trusted(machine)
                         ? ""
                         : "# Do not rely on them: the record contradicts the model, or the fit "
                           "was not complete.\n",
                     write_scene(machine.scene));
}

int identify(const IdentifyOptions& options) {
  if (options.scene_file.empty()) throw InputError("which machine? give --scene FILE");
  const auto is_machine = [](const std::filesystem::path& file) {
    return file.extension() == ".toml";
  };
  if (is_machine(options.files.knocks) && !is_machine(options.scene_file)) {
    throw InputError(fmt::format("{0}: the knocks come first: ricochet identify {1} --scene {0}",
                                 options.files.knocks, options.scene_file));
  }
  const Scene scene = read_scene(options.scene_file);
  check_identifiable(scene, options.scene_file);
  const KnockRecord record = read_knock_record(options.files);
  if (!(options.fastest >= 0.1 && options.fastest <= 1000)) {
    throw InputError(fmt::format("--fastest {}: must be within 0.1..1000 rad/s", options.fastest));
  }
  refuse_same_files(
      {{"--out", options.out}, {"--plot", options.plot}},
      {options.scene_file, options.files.knocks, options.files.speed, options.files.marks});
  const Solver solver = solver_named(options.solver, "--solver");
  if (solver.capabilities.derivatives != Capabilities::Order::gradient ||
      solver.capabilities.needs_constraints || solver.capabilities.needs_smoothing) {
    throw InputError(fmt::format(
        "--solver {}: must need gradients and nothing else, such as nlopt-lbfgs", options.solver));
  }
  const KnockLoss loss(scene, record);
  const IdentifiedMachine machine = limited(options.seconds, [&] {
    return studies::identification::identify(loss, solver, options.fastest);
  });
  report::Plot plot;
  if (!options.plot.empty()) plot = report::plot_of(knock_charts(loss, machine.fit.x));
  write_files(
      {{options.out, machine_text(machine, options.files.knocks)}, {options.plot, plot.svg}});
  if (options.json) {
    fmt::print("{}\n", json_of(machine, loss, solver.name).dump(2));
  } else {
    print_machine(machine, loss, std::filesystem::path(options.scene_file).stem().string(),
                  solver.name);
  }
  report::require_none(plot.failures);
  if (!machine.complete) {
    return report_incomplete(options.seconds, "the best fit so far has no intervals");
  }
  return is_trusted(machine) ? 0 : 1;
}

}  // namespace

void add_identify(CommandLine& line) {
  CLI::App* command = line.add(
      "identify", "Fit restitution, friction and clearance to recorded knocks",
      "  ricochet identify knocks.csv --scene machine.toml --speed speed.csv --marks marks.csv\n"
      "  ricochet identify knocks.csv --scene machine.toml --omega 5 --plot residuals.svg");
  const auto options = std::make_shared<IdentifyOptions>();
  add_value(command, "knocks", options->files.knocks,
            "CSV file: time [s] of each knock; perhaps strength, omega [rad/s]", "FILE")
      ->required();
  add_value(command, "--scene", options->scene_file, "A machine file (TOML); - is standard input",
            "FILE");
  command->add_option("--omega", options->files.omega, "Constant speed of the plate [rad/s]");
  add_value(command, "--speed", options->files.speed,
            "CSV file: time [s], omega [rad/s] of the plate; linear in between", "FILE");
  add_value(command, "--marks", options->files.marks, "CSV file: time [s] of marks on the plate",
            "FILE");
  add_value(command, "--mark-angle", options->files.mark_angle, "Angle alpha [rad] at a mark");
  add_value(command, "--mark-deviation", options->files.mark_deviation,
            "Standard deviation [rad] of --mark-angle; 0: exact");
  add_value(command, "--lag-deviation", options->files.lag_deviation,
            "Standard deviation [s] of the lag between two files; 0: one clock");
  add_value(command, "--solver", options->solver, "Solver that takes gradients", "SOLVER");
  add_value(command, "--fastest", options->fastest, "End of the speed range [rad/s]");
  add_seconds(command, options->seconds);
  add_value(command, "--out", options->out, "Machine file (TOML) for the fitted machine", "FILE");
  add_value(command, "--plot", options->plot, "SVG file for a chart of the residuals", "FILE");
  add_format(command, options->json);
  line.on_call(command, [options] { return identify(*options); });
}

}  // namespace ricochet::cli
