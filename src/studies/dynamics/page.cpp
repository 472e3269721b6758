#include "src/studies/dynamics/page.h"

#include <fmt/format.h>

#include "src/studies/dynamics/sections.h"

namespace ricochet::studies::dynamics {

report::Section origin_section(const Study& study) {
  report::Section section{"origin", "What made this report"};
  section.paragraphs = {fmt::format(
      "ricochet 0.1.0, built with {} {}; {:.1f} s. Controls: {} a decade, tolerances from 1e-3 to "
      "{:.0e}, steps from a tenth of the mean time between impacts to a {:.0f}th part of it. Every "
      "number but the times comes out the same again.",
#ifdef __clang__
      "Clang",
#else
      "GCC",
#endif
      __VERSION__, study.seconds, study.plan.work.per_decade, study.plan.work.tolerance,
      study.plan.work.steps)};
  report::Table table{"Methods, and the libraries behind them.",
                      {{"method", report::Alignment::left},
                       {"version", report::Alignment::left},
                       {"control", report::Alignment::left}},
                      {}};
  for (const auto& integrator : study.integrators) {
    table.rows.push_back({{integrator.name}, {integrator.version}, {integrator.control}});
  }
  for (const auto& integrator : study.penalty_integrators) {
    table.rows.push_back(
        {{integrator.name + ", through contacts"}, {integrator.version}, {integrator.control}});
  }
  section.tables = {std::move(table)};
  return section;
}

report::Page page_of(const Study& study) {
  report::Page page;
  page.title = "How well is the motion computed?";
  page.intro = {
      "A carrier that hits its track is a small mass between two walls: it flies, it bounces, it "
      "may stick. This report asks six things of such a motion. Does a contact law lose in an "
      "impact what it is told to lose? What do numerical methods pay for accurate impact times? "
      "Where do they fail? Is the motion chaotic, so that nobody could compute it for long? Does "
      "it matter whether a wall is hard or gives way? And how much of the model does a scene need?",
      "Every figure here is computed. Every section begins with what it found. Impacts count if "
      "they are faster than a scene's limit. Restitution is the speed after an impact over that "
      "before."};
  page.sections = {restitution_section(study.laws), speed_section(study.works)};
  for (const SceneWork& work : study.works) page.sections.push_back(work_section(work));
  for (const SceneWork& work : study.stiff_works) page.sections.push_back(work_section(work));
  page.sections.push_back(failure_modes_section(study.hazards));
  page.sections.push_back(stability_section(study.stability));
  page.sections.push_back(lyapunov_section(study.lyapunov));
  page.sections.push_back(fidelity_section(study.fidelity));
  page.sections.push_back(levels_section(study.levels));
  page.sections.push_back(origin_section(study));
  return page;
}

}  // namespace ricochet::studies::dynamics
