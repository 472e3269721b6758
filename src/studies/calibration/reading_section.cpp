#include <fmt/format.h>

#include <cmath>

#include "src/studies/calibration/sections.h"

namespace ricochet::studies::calibration {
namespace {

using carrier_track::name_of;

constexpr std::size_t shown = 31;

report::Table table_of(const std::vector<RankedFit>& readings) {
  report::Table table{
      "Readings by how far their best fit stays from the paper's claims. Constants: how many were "
      "fitted. Error: root mean square of ln(threshold / paper). Within: thresholds within 5 % of "
      "the paper's. Counts: quiet counts that equal the paper's. Purity, misclassified and "
      "loudness: of the worst case. AICc: error weighed against constants; lower is better.",
      {{"reading", report::Alignment::left},
       {"constants"},
       {"misfit"},
       {"error [%]"},
       {"within"},
       {"counts"},
       {"purity [%]"},
       {"misclassified [%]"},
       {"loudness"},
       {"examples"},
       {"AICc"}},
      {}};
  for (std::size_t i = 0; i < std::min(shown, readings.size()); ++i) {
    const auto& [fit, a] = readings[i];
    table.rows.push_back({{name_of(fit.reading)},
                          {fmt::format("{}", fit.freed.size())},
                          {fmt::format("{:.1f}", fit.misfit)},
                          {fmt::format("{:.1f}", 100 * a.threshold_error)},
                          {fmt::format("{} of 10", a.within)},
                          {fmt::format("{} of 10", a.exact_counts)},
                          {fmt::format("{:.0f}", 100 * a.purity)},
                          {fmt::format("{:.1f}", 100 * a.misclassified)},
                          {fmt::format("{:.2f}", a.loudness)},
                          {fmt::format("{} of 20", a.right_examples)},
                          {fmt::format("{:.1f}", a.criterion)}});
  }
  return table;
}

report::Figure error_chart(const Study& study) {
  report::Chart chart;
  chart.name = "error-against-freedom";
  chart.title = "Error of the thresholds against fitted constants";
  chart.x = {"fitted constants", report::Scale::linear, report::Range{1, 13}};
  chart.y = {"error of the thresholds [%]", report::Scale::logarithmic};
  report::Series readings{"another reading", report::Mark::points, {}};
  for (const RankedFit& r : study.readings) {
    readings.samples.push_back({static_cast<double>(r.fit.freed.size()),
                                std::max(0.1, 100 * r.appraisal.threshold_error)});
  }
  report::Series frontier{"the best reading, constants held", report::Mark::line, {}};
  for (auto r = study.frontier.rbegin(); r != study.frontier.rend(); ++r) {
    frontier.samples.push_back({static_cast<double>(r->fit.freed.size()),
                                std::max(0.1, 100 * r->appraisal.threshold_error)});
  }
  chart.series = {std::move(readings), std::move(frontier)};
  chart.lines = {{report::Direction::horizontal, 5, "5 %"}};
  chart.width = 720;
  return {chart,
          "A reading that needs many constants to come as near as one with few has memorised the "
          "paper rather than explained it."};
}

}  // namespace

report::Section reading_section(const Study& study) {
  report::Section section{"readings", "Which reading comes nearest"};
  const auto& [fit, a] = study.readings.front();
  section.paragraphs = {
      fmt::format("Nearest comes {}: {}. With {} constants fitted its thresholds are {:.1f} % off "
                  "in the root mean square, {} of 10 quiet counts are the paper's, and {} of 20 "
                  "example speeds lie on the side where the paper shows them.",
                  name_of(fit.reading), description_of(fit.reading), fit.freed.size(),
                  100 * a.threshold_error, a.exact_counts, a.right_examples),
      fmt::format("Readings whose misfits differ by less than two or three cannot be told apart by "
                  "searches of this length. So of the best four whose cases share one scene the "
                  "one with the lowest AICc is looked into below: {}.",
                  name_of(study.choice().fit.reading)),
      "The misfit is what the searches minimise: for each case the distances of the six parts of "
      "its score from the claim, each over a tolerance, and a share for the shape of the counts. "
      "0 would be the paper, word for word."};
  section.figures = {error_chart(study)};
  section.tables = {table_of(study.readings)};
  return section;
}

}  // namespace ricochet::studies::calibration
