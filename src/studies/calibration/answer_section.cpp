#include <fmt/format.h>

#include <map>

#include "src/studies/calibration/sections.h"

namespace ricochet::studies::calibration {
namespace {

/// The best fit with each answer.
using Best = std::map<std::string, const RankedFit*>;

}  // namespace

report::Section answer_section(const Study& study) {
  report::Section section{"answers", "What each open question decides"};
  section.paragraphs = {
      "The paper leaves nine questions open. Every answer is shown with the best reading that "
      "gives it: what an answer costs is what its reading is further off than the best."};
  report::Table table{"The questions, the answers, and the best reading for each.",
                      {{"question", report::Alignment::left},
                       {"answer", report::Alignment::left},
                       {"misfit"},
                       {"error of the thresholds [%]"},
                       {"quiet counts right"},
                       {"examples right"}},
                      {}};
  std::vector<std::string> questions;
  std::map<std::string, Best> best;  // by question
  for (const RankedFit& r : study.readings) {
    for (const auto& [question, answer] : answers_of(r.fit.reading)) {
      if (!best.contains(question)) questions.push_back(question);
      best[question].try_emplace(answer, &r);  // by rising misfit: the first is the best
    }
  }
  for (const std::string& question : questions) {
    for (const auto& [answer, r] : best[question]) {
      const bool is_best = r == &study.readings.front();
      table.rows.push_back({{question},
                            {answer},
                            {fmt::format("{:.1f}", r->fit.misfit),
                             is_best ? report::State::good : report::State::neutral},
                            {fmt::format("{:.1f}", 100 * r->appraisal.threshold_error)},
                            {fmt::format("{} of 10", r->appraisal.exact_counts)},
                            {fmt::format("{} of 20", r->appraisal.right_examples)}});
    }
  }
  section.tables = {std::move(table)};
  return section;
}

}  // namespace ricochet::studies::calibration
