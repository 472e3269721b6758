#pragma once

#include <string>
#include <vector>

#include "src/report/chart.h"

namespace ricochet::report {

/// A chart for a page: a picture, or the reason why it could not be drawn.
struct DrawnChart {
  std::string name, title;
  std::string svg;
  std::string failure = {};  ///< empty if it is drawn

  bool is_drawn() const { return failure.empty(); }
};

/// Draws a chart. Throws only std::bad_alloc: other errors are returned as the failure of this
/// chart.
DrawnChart draw(const Chart& chart);

/// Returns the SVG with the chart's numbers, for the buttons of reports/templates/chart_data.js, or
/// a paragraph with the reason for the failure.
std::string html_of(const Chart& chart, const DrawnChart& drawn);

/// Returns a reference to the picture's file, or the same reason.
std::string markdown_of(const DrawnChart& chart);

/// "chart NAME could not be drawn: REASON", for the end of a command.
std::string failure_of(const DrawnChart& chart);

/// Charts with different names, one below the other: a picture for a separate file.
struct Plot {
  std::string svg = {};  ///< of those that could be drawn; empty if there is none
  std::vector<std::string> failures = {};
};
Plot plot_of(const std::vector<Chart>& charts);

/// Throws std::runtime_error with these lines if there are any. To be called after all other
/// output.
void require_none(const std::vector<std::string>& failures);

}  // namespace ricochet::report
