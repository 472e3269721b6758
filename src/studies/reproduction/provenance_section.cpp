#include <fmt/format.h>

#include <thread>

#include "problems/carrier_track/scene/scene_file.h"
#include "src/studies/reproduction/sections.h"

namespace ricochet::studies::reproduction {

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
      fmt::format("Reading \"{}\": {}. Made by {}.", study.reading.name, study.reading.description,
                  study.reading.provenance)};
  report::Table constants{
      "Constants of the reading; restitution, friction and disturbance are the case's.",
      {{"constant", report::Alignment::left},
       {"value"},
       {"unit", report::Alignment::left},
       {"", report::Alignment::left}},
      {}};
  const auto& fitted = study.reading;
  for (const carrier_track::Open open : open_of(fitted.reading)) {
    const auto i = static_cast<std::size_t>(open);
    const auto& constant = carrier_track::open_constants()[i];
    const bool freed = contains(fitted.freed, open);
    constants.rows.push_back({{std::string(constant.name)},
                              {fmt::format("{:.4g}", fitted.constants[i])},
                              {std::string(constant.unit)},
                              {freed ? "fitted" : "held"}});
  }
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

}  // namespace ricochet::studies::reproduction
