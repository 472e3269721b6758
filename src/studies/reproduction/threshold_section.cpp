#include <fmt/format.h>

#include <cmath>

#include "src/report/text.h"
#include "src/studies/reproduction/sections.h"

namespace ricochet::studies::reproduction {
namespace {

using namespace carrier_track;
using report::Alignment;
using report::Cell;
using report::State;
using report::text_or_dash;

Cell error_cell(const std::optional<double>& computed, const std::optional<double>& paper) {
  if (!computed || !paper) return {"–"};
  return {fmt::format("{:+.0f} %", 100 * (*computed / *paper - 1))};
}

report::Table table_of_thresholds(const std::vector<CaseStudy>& cases) {
  report::Table table{"Thresholds and quiet counts, the paper's and those computed.",
                      {{"case", Alignment::left},
                       {"restitution"},
                       {"friction"},
                       {"disturbance [N]"},
                       {"paper's threshold [rad/s]"},
                       {"threshold [rad/s]"},
                       {"error"},
                       {"first loud [rad/s]"},
                       {"paper's quiet count"},
                       {"quiet count"},
                       {"error"}},
                      {}};
  for (const CaseStudy& c : cases) {
    const Claim& claim = c.the_case.claim;
    const double quiet = c.score.quiet_count;
    table.rows.push_back({{c.the_case.id},
                          {fmt::format("{}", c.the_case.restitution)},
                          {fmt::format("{}", c.the_case.friction)},
                          {fmt::format("{}", c.the_case.disturbance)},
                          {text_or_dash(claim.threshold, "{}")},
                          {text_or_dash(c.score.threshold, "{:.3f}")},
                          error_cell(c.score.threshold, claim.threshold),
                          {text_or_dash(c.score.first_loud, "{:.3f}")},
                          {text_or_dash(claim.quiet_count, "{}")},
                          {fmt::format("{}", quiet)},
                          error_cell(quiet, claim.quiet_count)});
  }
  return table;
}

report::Table table_of_quality(const std::vector<CaseStudy>& cases) {
  report::Table table{
      "How sharply quiet and loud divide. Misclassified: share of speeds on the wrong side of the "
      "threshold (the paper: none). Purity: share of speeds below the paper's threshold with the "
      "quiet count or one more or less (the paper: all). Loudness: median count above it over the "
      "quiet count (a significant increase: at least 1.5). Where the paper has no threshold, the "
      "computed one takes its place.",
      {{"case", Alignment::left}, {"misclassified"}, {"purity"}, {"loudness"}},
      {}};
  for (const CaseStudy& c : cases) {
    const Score& s = c.score;
    const bool loud = s.loudness && *s.loudness >= 1.5;
    table.rows.push_back({{c.the_case.id},
                          {fmt::format("{:.1f} %", 100 * s.misclassified)},
                          {s.purity ? fmt::format("{:.0f} %", 100 * *s.purity) : "–"},
                          {text_or_dash(s.loudness, "{:.1f}"), loud ? State::good : State::bad}});
  }
  return table;
}

report::Table table_of_examples(const std::vector<CaseStudy>& cases) {
  report::Table table{"The speeds of Figures 5-14 on the side where the paper shows them, or not.",
                      {{"figure", Alignment::left},
                       {"case", Alignment::left},
                       {"shown quiet at [rad/s]"},
                       {"count"},
                       {"shown loud at [rad/s]"},
                       {"count"},
                       {"quiet up to"}},
                      {}};
  for (const CaseStudy& c : cases) {
    if (!c.the_case.claim.figure) continue;
    std::vector<Cell> row = {{fmt::format("{}", c.the_case.claim.figure->number)}, {c.the_case.id}};
    for (const Example& e : c.score.examples) {
      row.push_back({fmt::format("{}", e.omega)});
      row.push_back({fmt::format("{}", e.count), e.right ? State::good : State::bad});
    }
    row.push_back({fmt::format("{}", std::floor(quiet_limit(c.score.quiet_count)))});
    table.rows.push_back(std::move(row));
  }
  return table;
}

report::Figure chart_of_thresholds(const std::vector<CaseStudy>& cases) {
  report::Chart chart;
  chart.name = "thresholds";
  chart.title = "Threshold of every case";
  chart.x.label = "case";
  chart.y = {"threshold [rad/s]", report::Scale::logarithmic, report::Range{1, 20}};
  report::Series paper{"paper", report::Mark::points, {}};
  report::Series computed{"computed", report::Mark::points, {}};
  for (const CaseStudy& c : cases) {
    const auto position = static_cast<double>(chart.x.categories.size());
    chart.x.categories.push_back(c.the_case.id);
    paper.samples.push_back({position, c.the_case.claim.threshold});
    computed.samples.push_back({position, c.score.threshold});
  }
  chart.series = {paper, computed};
  chart.width = 640;
  return {
      chart,
      "Restitution is 0.1 in C1, C3, C5, C7, C9 and C12, else 0.9. The paper has no threshold for "
      "C11 and C12."};
}

std::string words_on_c11(const std::vector<CaseStudy>& cases) {
  for (const CaseStudy& c : cases) {
    if (c.the_case.id != "C11") continue;
    if (!c.score.threshold) return "C11 has no quiet range, as the paper says.";
    return fmt::format(
        "Of C11 the paper says that collisions increase at every speed. The model disagrees: it "
        "has "
        "{} collisions per window below {:.2f} rad/s, and more above, as in the other cases.",
        c.score.quiet_count, *c.score.threshold);
  }
  return {};
}

}  // namespace

report::Section threshold_section(const std::vector<CaseStudy>& cases) {
  report::Section section{"thresholds", "Thresholds, against the paper"};
  std::string wrong;
  for (const CaseStudy& c : cases) {
    for (const Example& e : c.score.examples) {
      if (e.right) continue;
      wrong += fmt::format("{}{} at {} rad/s ({} collisions, shown {})", wrong.empty() ? "" : ", ",
                           c.the_case.id, e.omega, e.count, e.loud ? "loud" : "quiet");
    }
  }
  section.paragraphs = {
      wrong.empty() ? std::string("All speeds that the paper shows are on the paper's side.")
                    : fmt::format("On the wrong side: {}.", wrong),
      words_on_c11(cases)};
  section.tables = {table_of_thresholds(cases), table_of_quality(cases), table_of_examples(cases)};
  section.figures = {chart_of_thresholds(cases)};
  return section;
}

}  // namespace ricochet::studies::reproduction
