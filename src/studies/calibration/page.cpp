#include "src/studies/calibration/page.h"

#include <fmt/format.h>

#include <cmath>

#include "src/studies/calibration/sections.h"

namespace ricochet::studies::calibration {
namespace {

report::Section origin_section(const Study& study) {
  const Search& search = study.plan.search;
  report::Section section{"origin", "What made this report"};
  section.paragraphs = {fmt::format(
      "ricochet 0.1.0. Global search by {} ({}), polish by {} ({}) on the smooth misfit and by {} "
      "({}) on the misfit; seed {}; {} evaluations a reading, {} for each of the best four, {} for "
      "each try to "
      "hold a constant, {} for each case left out; judged at speeds {} rad/s apart. The same "
      "command gives the same numbers, bit for bit, on any number of threads.",
      search.global.name, search.global.version, search.least_squares.name,
      search.least_squares.version, search.local.name, search.local.version, search.seed,
      search.evaluations, study.plan.finalist_evaluations, study.plan.pin_evaluations,
      study.plan.left_out_evaluations, study.plan.step)};
  return section;
}

}  // namespace

report::Page page_of(const Study& study) {
  const Appraisal& a = study.choice().appraisal;
  report::Page page;
  page.title = "Which reading of the paper gives its thresholds?";
  page.intro = {
      "A braiding machine moves its yarn carriers along a track in which they have some play. "
      "Turned "
      "slowly, a carrier knocks against the track a few times a turn; turned too fast, it hammers. "
      "A paper of 2024 reports at which speed of the driver plate this begins, for ten "
      "combinations "
      "of bounciness, friction and disturbance, but leaves nine questions about its equations and "
      "about ten of its constants open. This report asks which answers, and which constants, give "
      "the paper's thresholds: are they real, and what do they depend on?",
      fmt::format(
          "The best answer found has {} fitted constants. Its thresholds are {:.1f} % off in "
          "the root mean square, {} of 10 within 5 %; {} of 10 counts below the threshold "
          "are the paper's; {} of 20 example speeds lie on the side where the paper shows "
          "them. Cases that a fit has not seen it predicts within {:.1f} %.",
          study.choice().fit.freed.size(), 100 * a.threshold_error, a.within, a.exact_counts,
          a.right_examples, 100 * prediction_error(study.predictions))};
  if (study.readings.size() > 1) {
    page.sections = {reading_section(study), answer_section(study)};
  }
  if (!study.rankings.empty()) page.sections.push_back(ranking_section(study));
  page.sections.push_back(frontier_section(study));
  page.sections.push_back(prediction_section(study));
  page.sections.push_back(constant_section(study));
  page.sections.push_back(origin_section(study));
  return page;
}

}  // namespace ricochet::studies::calibration
