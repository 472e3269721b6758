#include <fmt/format.h>

#include <algorithm>

#include "src/studies/calibration/sections.h"

namespace ricochet::studies::calibration {

report::Section ranking_section(const Study& study) {
  report::Section section{"rankings", "Does another search rank the readings alike?"};
  section.paragraphs = {
      "A reading may rank low because nobody found its best constants. So other searches, with "
      "another seed or another solver, rank the same readings. 1: the same order; 0: no relation."};
  report::Table table{
      "Misfits of the readings by each search, and the rank correlation with the "
      "first (Spearman).",
      {{"reading", report::Alignment::left}},
      {}};
  const Search& own = study.plan.search;
  table.columns.push_back({fmt::format("{}, seed {}", own.global.name, own.seed)});
  std::vector<report::Cell> correlations = {{"rank correlation"}, {"1"}};
  for (const Ranking& r : study.rankings) {
    table.columns.push_back({fmt::format("{}, seed {}", r.search.global.name, r.search.seed)});
    correlations.push_back({fmt::format("{:.2f}", r.rank_correlation)});
  }
  table.rows.push_back(std::move(correlations));
  for (const RankedFit& own_fit : study.readings) {
    const auto& reading = own_fit.fit.reading;
    std::vector<report::Cell> row = {{name_of(reading)},
                                     {fmt::format("{:.1f}", own_fit.fit.misfit)}};
    for (const Ranking& r : study.rankings) {
      const auto found = std::find(r.readings.begin(), r.readings.end(), reading);
      const auto i = static_cast<std::size_t>(found - r.readings.begin());
      row.push_back({i < r.misfits.size() ? fmt::format("{:.1f}", r.misfits[i]) : "–"});
    }
    table.rows.push_back(std::move(row));
  }
  section.tables = {std::move(table)};
  return section;
}

}  // namespace ricochet::studies::calibration
