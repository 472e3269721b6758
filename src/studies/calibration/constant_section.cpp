#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/studies/calibration/sections.h"

namespace ricochet::studies::calibration {
namespace {

using namespace carrier_track;

report::Figure profile_chart(const Profile& profile) {
  const OpenConstant& c = open_constants()[static_cast<std::size_t>(profile.constant)];
  report::Chart chart;
  chart.name = "profile-" + std::string(c.name);
  std::replace(chart.name.begin(), chart.name.end(), '_', '-');
  chart.title = words_of(profile.constant);
  chart.x.label = c.unit.empty() ? words_of(profile.constant)
                                 : fmt::format("{} [{}]", words_of(profile.constant), c.unit);
  chart.y = {"misfit, the others fitted anew", report::Scale::linear};
  report::Series series{"", report::Mark::line, {}};
  for (const auto& [value, misfit] : profile.points) series.samples.push_back({value, misfit});
  chart.series = {std::move(series)};
  chart.lines = {{report::Direction::vertical, profile.value, "fitted"}};
  chart.width = 360;
  chart.height = 240;
  return {chart, ""};
}

report::Figure sensitivity_map(const Study& study) {
  report::Chart chart;
  chart.name = "sensitivity";
  chart.title = "What a threshold owes to a constant";
  chart.x.label = "case";
  chart.y.label = "constant";
  const Fit& fit = study.choice().fit;
  report::HeatMap map{"change of ln(threshold) per change", {}, std::nullopt};
  for (const Open open : fit.freed) {
    chart.y.categories.push_back(words_of(open));
    map.rows.emplace_back();
  }
  for (const CaseSensitivity& row : study.sensitivities) {
    chart.x.categories.push_back(row.case_id);
    for (std::size_t i = 0; i < row.slopes.size(); ++i) map.rows[i].push_back(row.slopes[i]);
  }
  chart.heat_map = std::move(map);
  chart.width = 720;
  chart.height = 120 + 32 * static_cast<int>(fit.freed.size());
  return {chart,
          "Of a constant whose size is unknown: the percentage by which a threshold rises when it "
          "grows by 1 %. Of an angle, a velocity or a place: the change of ln(threshold) when it "
          "moves across its whole range."};
}

report::Table interval_table(const std::vector<Profile>& profiles) {
  report::Table table{
      "How well each constant is determined: between these values the misfit, with all other "
      "constants fitted anew, rises by less than one tolerance of one part of one case. Open: "
      "nothing seen ends it.",
      {{"constant", report::Alignment::left},
       {"value"},
       {"from"},
       {"to"},
       {"unit", report::Alignment::left},
       {"determined", report::Alignment::left}},
      {}};
  for (const Profile& p : profiles) {
    const OpenConstant& c = open_constants()[static_cast<std::size_t>(p.constant)];
    table.rows.push_back(
        {{words_of(p.constant)},
         {fmt::format("{:.4g}", p.value)},
         {fmt::format("{}{:.3g}", p.lower_open ? "open, " : "", p.lower)},
         {fmt::format("{}{:.3g}", p.upper_open ? "open, " : "", p.upper)},
         {std::string(c.unit)},
         {p.lower_open || p.upper_open ? "no" : "yes",
          p.lower_open || p.upper_open ? report::State::bad : report::State::good}});
  }
  return table;
}

}  // namespace

report::Section constant_section(const Study& study) {
  report::Section section{"constants", "What the thresholds depend on"};
  const auto determined =
      std::count_if(study.profiles.begin(), study.profiles.end(),
                    [](const Profile& p) { return !p.lower_open && !p.upper_open; });
  section.paragraphs = {fmt::format(
      "{} of the {} fitted constants are determined on both sides by the paper's claims.",
      determined, study.profiles.size())};
  section.tables = {interval_table(study.profiles)};
  section.figures = {sensitivity_map(study)};
  for (const Profile& p : study.profiles) section.figures.push_back(profile_chart(p));
  return section;
}

}  // namespace ricochet::studies::calibration
