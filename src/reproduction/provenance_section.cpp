#include <fmt/format.h>

#include <thread>

#include "problems/carrier_track/scene_file.h"
#include "src/reproduction/sections.h"

namespace ricochet::reproduction {

report::Section provenance_section(const Study& study) {
  const StudyPlan& plan = study.plan;
  report::Section section{"provenance", "What made this report"};
  section.paragraphs = {
      fmt::format(
          "ricochet 0.1.0, built with {} {}; {} threads; {:.1f} s. Speeds every {} rad/s up "
          "to {} rad/s; the grid's every {} rad/s; {} instances and {} evaluations a run in "
          "the comparison of solvers.",
#ifdef __clang__
          "Clang",
#else
          "GCC",
#endif
          __VERSION__, std::thread::hardware_concurrency(), study.seconds, plan.scan.step,
          plan.scan.highest, plan.grid_step, plan.comparison.instances,
          plan.comparison.budget.evaluations),
      "Every number but the times comes out the same, bit for bit, on any number of threads: a "
      "run's "
      "seed is a hash of problem, solver, instance and number.",
      fmt::format("Reading \"{}\": {}. Its constants:", study.reading.name,
                  study.reading.description)};
  const carrier_track::Scene& s = study.reading.scene;
  report::Table constants{
      "Constants of the reading; restitution, friction and disturbance are the "
      "case's. Only the mass is the paper's.",
      {{"constant", report::Alignment::left}, {"value"}},
      {}};
  const auto row = [&constants](const char* name, double value, const char* unit) {
    constants.rows.push_back({{name}, {fmt::format("{:.4g} {}", value, unit)}});
  };
  row("mass", s.mass, "kg");
  row("clearance between the walls", 1e3 * (s.wall_upper - s.wall_lower), "mm");
  row("normal force", s.normal_force, "N");
  row("pull towards the lower wall", s.pull, "N");
  row("centrifugal mass times radius", s.centrifugal_mass_radius, "kg m");
  row("slider mass times radius", s.slider_mass_radius, "kg m");
  row("phase", s.phase, "rad");
  row("frequency of the disturbance", s.disturbance_frequency, "rad/s");
  row("start position", 1e3 * s.start_position, "mm");
  row("start velocity", s.start_velocity, "m/s");
  row("window", std::get<carrier_track::Revolutions>(s.window).count, "turns");
  row("slowest impact that counts", 1e3 * s.slowest, "mm/s");
  report::Table versions{
      "Solvers, and the libraries behind them.",
      {{"solver", report::Alignment::left}, {"version", report::Alignment::left}},
      {}};
  for (const Solver& solver : study.solvers) {
    versions.rows.push_back({{solver.name}, {solver.version}});
  }
  section.tables = {std::move(constants), std::move(versions)};
  return section;
}

}  // namespace ricochet::reproduction
