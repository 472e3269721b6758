#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "src/statistics/bootstrap.h"
#include "src/studies/surrogate/derivative_check.h"

namespace ricochet::studies::surrogate {
namespace {

std::size_t of(const AgreementRow& row, Cause cause) {
  return row.by_cause[static_cast<std::size_t>(cause)];
}

AgreementRow total_of(const DerivativeCheckStudy& study) {
  AgreementRow total{"all", "", study.points, {}, {}};
  for (const AgreementRow& row : study.rows) {
    total.errors.insert(total.errors.end(), row.errors.begin(), row.errors.end());
    for (std::size_t c = 0; c < causes; ++c) total.by_cause[c] += row.by_cause[c];
  }
  std::sort(total.errors.begin(), total.errors.end());
  return total;
}

std::vector<report::Cell> cells_of(const AgreementRow& row) {
  std::vector<report::Cell> cells = {{row.family}, {row.function}, {fmt::format("{}", row.points)}};
  for (const double share : {0.5, 0.9, 0.99, 1.0}) {
    cells.push_back({fmt::format("{:.1e}", quantile(row.errors, share))});
  }
  for (const Cause cause : {Cause::flat, Cause::reach, Cause::rounding}) {
    cells.push_back({fmt::format("{}", of(row, cause))});
  }
  const std::size_t unexplained = of(row, Cause::unexplained);
  cells.push_back({fmt::format("{}", unexplained),
                   unexplained == 0 ? report::State::good : report::State::bad});
  return cells;
}

report::Table family_table(const DerivativeCheckStudy& study, const AgreementRow& total) {
  report::Table table{
      fmt::format("Relative difference between exact and extrapolated derivatives, by family of "
                  "problems: quantiles over random points; and "
                  "what the differences above {:.0e} come from.",
                  outlier),
      {{"family", report::Alignment::left},
       {"of its", report::Alignment::left},
       {"points"},
       {"median"},
       {"0.9 below"},
       {"0.99 below"},
       {"worst"},
       {"flat"},
       {"short reach"},
       {"rounding"},
       {"unexplained"}},
      {}};
  for (const AgreementRow& row : study.rows) table.rows.push_back(cells_of(row));
  table.rows.push_back(cells_of(total));
  return table;
}

const char* name_of(Cause cause) {
  switch (cause) {
    case Cause::none:
      return "none";
    case Cause::flat:
      return "flat";
    case Cause::reach:
      return "short reach";
    case Cause::rounding:
      return "rounding";
    case Cause::unexplained:
      return "unexplained";
  }
  return "";
}

report::Table outlier_table(const DerivativeCheckStudy& study) {
  constexpr std::size_t most = 20;
  report::Table table{
      fmt::format("The first {} of {} outliers: the unexplained, then those that differ most. "
                  "Derivatives are along a random direction of a box of width 1; the reach is how "
                  "far, in that box, the motion is told to keep its structure.",
                  std::min(most, study.outliers.size()), study.outliers.size()),
      {{"problem", report::Alignment::left},
       {"at, first coordinate"},
       {"exact"},
       {"by differences"},
       {"their own error"},
       {"reach"},
       {"cause", report::Alignment::left}},
      {}};
  for (std::size_t k = 0; k < std::min(most, study.outliers.size()); ++k) {
    const Outlier& outlier = study.outliers[k];
    const Comparison& c = outlier.comparison;
    table.rows.push_back(
        {{outlier.problem},
         {fmt::format("{:.9g}", outlier.point[0])},
         {fmt::format("{:.6g}", c.exact)},
         {fmt::format("{:.6g}", c.difference)},
         {fmt::format("{:.0e}", c.error)},
         {fmt::format("{:.0e}", c.trust.reach)},
         {name_of(c.cause),
          c.cause == Cause::unexplained ? report::State::bad : report::State::neutral}});
  }
  return table;
}

report::Figure tails_of(const DerivativeCheckStudy& study) {
  report::Chart chart;
  chart.name = "agreement";
  chart.title = "How many derivatives differ by more";
  chart.x = {"relative difference", report::Scale::logarithmic, report::Range{1e-16, 10}};
  chart.y = {"share of the derivatives", report::Scale::logarithmic};
  for (const AgreementRow& row : study.rows) {
    report::Series series{row.family + ", " + row.function, report::Mark::line, {}};
    for (int k = 0; k <= 64; ++k) {
      const double limit = 1e-16 * std::pow(10.0, 0.25 * k);
      const auto larger =
          row.errors.end() - std::upper_bound(row.errors.begin(), row.errors.end(), limit);
      if (larger == 0) break;
      series.samples.push_back(
          {limit, static_cast<double>(larger) / static_cast<double>(row.errors.size())});
    }
    if (!series.samples.empty()) chart.series.push_back(std::move(series));
  }
  chart.lines = {{report::Direction::vertical, outlier, "outliers beyond"}};
  chart.width = 640;
  chart.height = 420;
  return {chart,
          "Exact derivatives beside differences that are extrapolated to step 0. What there is of "
          "a tail is the differences' own: steps that lead over an event, and rounding."};
}

}  // namespace

report::Section derivative_check_section(const DerivativeCheckStudy& study) {
  report::Section section{"agreement", "Are the derivatives right?"};
  const AgreementRow total = total_of(study);
  if (total.errors.empty()) {
    section.paragraphs = {"Found: nothing, as no problem has derivatives."};
    return section;
  }
  const std::size_t unexplained = of(total, Cause::unexplained);
  section.paragraphs = {
      fmt::format(
          "Found: {}. At {} random points of {} families of problems exact derivatives and "
          "extrapolated differences differ by {:.0e} in the median and by less than {:.0e} at 99 "
          "%. "
          "{} of {} derivatives differ by more than {:.0e}: {} because both are next to nothing, "
          "{} because the differences' steps lead over an event and shorter ones agree, {} within "
          "the differences' own error, {} for no known reason.",
          unexplained == 0 ? "yes" : "not all", study.points, study.families,
          quantile(total.errors, 0.5), quantile(total.errors, 0.99), study.outliers.size(),
          total.errors.size(), outlier, of(total, Cause::flat), of(total, Cause::reach),
          of(total, Cause::rounding), unexplained == 0 ? "none" : std::to_string(unexplained)),
      fmt::format(
          "Every problem with derivatives is asked at random points of its box, scaled to width 1, "
          "for its objective's gradient and its constraints' Jacobian along a random direction. "
          "Beside them stand central differences of its values with steps from {:.0e} down by "
          "halves, {} times, extrapolated to step 0 where they agree best. The error is relative "
          "to the larger of the two. An outlier, beyond {:.0e}, is called flat if it is below "
          "{:.0e} of the function's value, or of 1, across the whole box; short reach if the "
          "gradient says that the motion changes its structure within four times the first step, "
          "and differences with steps of a quarter of that reach agree; rounding if it is below "
          "1e-3 and ten times what the extrapolation is estimated to be off, or is off from "
          "another "
          "from shorter steps. Seed {}.",
          first_step, 12, outlier, nothing, study.seed)};
  section.tables = {family_table(study, total)};
  if (!study.outliers.empty()) section.tables.push_back(outlier_table(study));
  section.figures = {tails_of(study)};
  return section;
}

}  // namespace ricochet::studies::surrogate
