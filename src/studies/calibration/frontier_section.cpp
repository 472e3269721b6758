#include <fmt/format.h>

#include <algorithm>

#include "src/studies/calibration/sections.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

/// What a fit holds that the one before it fitted.
std::string newly_held(const Fit& fit, const std::vector<Open>& fitted_before) {
  for (const Open open : fitted_before) {
    if (contains(fit.freed, open)) continue;
    const auto i = static_cast<std::size_t>(open);
    return fmt::format("{} = {:.4g} {}", words_of(open), fit.constants[i],
                       open_constants()[i].unit);
  }
  return "none";
}

report::Cell against(double value, const char* form, bool reached) {
  return {fmt::format(fmt::runtime(form), value),
          reached ? report::State::good : report::State::bad};
}

std::vector<report::Cell> row_of(const RankedFit& r, const std::vector<Open>& fitted_before) {
  const Appraisal& a = r.appraisal;
  return {{fmt::format("{}", r.fit.freed.size())},
          {newly_held(r.fit, fitted_before)},
          {fmt::format("{:.1f}", r.fit.misfit)},
          {fmt::format("{:.1f}", 100 * a.threshold_error)},
          against(a.within, "{} of 10", a.within == 10),
          against(a.exact_counts, "{} of 10", a.exact_counts == 10),
          against(100 * a.purity, "{:.0f}", a.purity >= 0.9),
          against(100 * a.misclassified, "{:.1f}", a.misclassified <= 0.02),
          against(a.loudness, "{:.2f}", a.loudness >= 1.5),
          against(a.right_examples, "{} of 20", a.right_examples == 20),
          against(100 * a.quiet_share, "{:.0f}", a.quiet_share == 0),
          {fmt::format("{:.1f}", a.criterion)}};
}

report::Table constants_of(const Fit& fit) {
  report::Table table{"The constants of the chosen fit.",
                      {{"constant", report::Alignment::left},
                       {"value"},
                       {"unit", report::Alignment::left},
                       {"", report::Alignment::left},
                       {"allowed", report::Alignment::left},
                       {"why", report::Alignment::left}},
                      {}};
  for (const Open open : open_of(fit.reading)) {
    const auto i = static_cast<std::size_t>(open);
    const OpenConstant& c = open_constants()[i];
    const bool freed = contains(fit.freed, open);
    table.rows.push_back({{words_of(open)},
                          {fmt::format("{:.4g}", fit.constants[i])},
                          {std::string(c.unit)},
                          {freed ? "fitted" : "held"},
                          {fmt::format("{:.3g} to {:.3g}", c.lower, c.upper)},
                          {std::string(c.why)}});
  }
  return table;
}

}  // namespace

report::Section frontier_section(const Study& study) {
  report::Section section{"frontier", "How few constants will do"};
  const RankedFit& choice = study.choice();
  section.paragraphs = {
      "Of the best reading one constant after the other is held at its natural value, what the "
      "paper or the scene suggests for it: m r_c = 0.078 kg m, a clearance of 2 mm, the weight as "
      "normal force, a start at rest in the middle, one turn. Each time the one that costs least.",
      fmt::format("Chosen is the fit with the lowest AICc, {} constants: it is what every other "
                  "command computes with.",
                  choice.fit.freed.size())};
  report::Table table{
      "The trade-off between constants and agreement. A tick: the goal of the column is reached "
      "(every threshold within 5 %, every count exact, purity 90 %, 2 % misclassified, loudness "
      "1.5, all examples right, and C11 never quiet).",
      {{"constants"},
       {"held from here on", report::Alignment::left},
       {"misfit"},
       {"error [%]"},
       {"within 5 %"},
       {"counts"},
       {"purity [%]"},
       {"misclassified [%]"},
       {"loudness"},
       {"examples"},
       {"C11 quiet [%]"},
       {"AICc"}},
      {}};
  std::vector<Open> fitted_before = study.frontier.front().fit.freed;
  for (const RankedFit& r : study.frontier) {
    table.rows.push_back(row_of(r, fitted_before));
    fitted_before = r.fit.freed;
  }
  section.tables = {std::move(table), constants_of(choice.fit)};
  return section;
}

}  // namespace ricochet::studies::calibration
