#include <fmt/format.h>

#include <cmath>

#include "src/report/text.h"
#include "src/studies/calibration/sections.h"

namespace ricochet::studies::calibration {

report::Section prediction_section(const Study& study) {
  report::Section section{"predictions", "Does it predict what it has not seen?"};
  const double seen = study.choice().appraisal.threshold_error;
  const double unseen = prediction_error(study.predictions);
  section.paragraphs = {fmt::format(
      "Each case is left out in turn, the constants are fitted anew to the other nine, "
      "and the threshold of the case is computed. These thresholds are {:.1f} % off in "
      "the root mean square; those that the fit has seen, {:.1f} %. {}",
      100 * unseen, 100 * seen,
      unseen <= 0.1 ? "A reading that only memorised would do far worse on what it has not seen."
                    : "So part of the agreement is memory.")};
  report::Table table{"Thresholds [rad/s] from fits that have not seen their case.",
                      {{"case", report::Alignment::left},
                       {"paper"},
                       {"chosen fit"},
                       {"not having seen it"},
                       {"off [%]"}},
                      {}};
  for (const Prediction& p : study.predictions) {
    std::optional<double> fitted;
    for (const CaseAppraisal& c : study.choice().appraisal.cases) {
      if (c.the_case.id == p.case_id) fitted = c.score.threshold;
    }
    const auto off =
        p.predicted ? std::optional(100 * std::log(*p.predicted / p.paper)) : std::nullopt;
    table.rows.push_back({{p.case_id},
                          {fmt::format("{}", p.paper)},
                          {report::text_or_dash(fitted, "{:.2f}")},
                          {report::text_or_dash(p.predicted, "{:.2f}")},
                          {report::text_or_dash(off, "{:+.1f}")}});
  }
  section.tables = {std::move(table)};
  return section;
}

}  // namespace ricochet::studies::calibration
