#pragma once

#include <string>
#include <vector>

#include "src/report/chart.h"
#include "src/report/json.h"

namespace ricochet::report {

/// Where the cells of a heat map lead: to a folder, #, and what stands in the link for the row and
/// for the column, joined. In the order of the chart's axes; empty: nowhere.
struct CellLinks {
  std::vector<std::string> rows, columns;
};

/// What reports/templates/chart_links.js needs: `box`, the pixels of the cells in the picture
/// (left, right, top, bottom), and for each of the `rows`, from the top, and `columns` its name and
/// its part of the address.
Json cell_links_data(const Chart& chart, const CellLinks& links);

}  // namespace ricochet::report
