#include "src/report/drawn_chart.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <exception>
#include <new>
#include <stdexcept>

#include "src/report/chart_csv.h"
#include "src/report/drawing.h"
#include "src/report/script_text.h"
#include "src/report/svg.h"
#include "src/report/text.h"

namespace ricochet::report {
namespace {

std::string words_for(const DrawnChart& chart) {
  return fmt::format("This chart could not be drawn: {}: {}",
                     chart.title.empty() ? chart.name : chart.title, chart.failure);
}

}  // namespace

DrawnChart draw(const Chart& chart) {
  try {
    return {chart.name, chart.title, to_svg(chart)};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    return {chart.name, chart.title, "", error.what()};
  }
}

std::string html_of(const Chart& chart, const DrawnChart& drawn) {
  if (!drawn.is_drawn()) {
    return fmt::format("<p class=\"bad\">{}</p>", escape_html(words_for(drawn)));
  }
  return drawn.svg + data_script("chart-csv", csv_of(chart));
}

std::string markdown_of(const DrawnChart& chart) {
  if (!chart.is_drawn()) return fmt::format("**{}**", escape_markdown(words_for(chart)));
  return fmt::format("![{}]({}.svg)", escape_markdown(chart.title), chart.name);
}

std::string failure_of(const DrawnChart& chart) {
  return fmt::format("chart {} could not be drawn: {}", chart.name, chart.failure);
}

Plot plot_of(const std::vector<Chart>& charts) {
  Plot plot;
  std::vector<std::string> svgs;
  for (const Chart& chart : charts) {
    const DrawnChart drawn = draw(chart);
    (drawn.is_drawn() ? svgs : plot.failures)
        .push_back(drawn.is_drawn() ? drawn.svg : failure_of(drawn));
  }
  if (!svgs.empty()) plot.svg = stacked(svgs);
  return plot;
}

void require_none(const std::vector<std::string>& failures) {
  if (!failures.empty()) throw std::runtime_error(fmt::format("{}", fmt::join(failures, "; ")));
}

}  // namespace ricochet::report
