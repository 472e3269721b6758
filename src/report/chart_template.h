#pragma once

#include "src/report/chart.h"
#include "src/report/page.h"
#include "src/report/page_template.h"
#include "src/report/text.h"

namespace ricochet::report {

/// Returns the chart's name, in lower-case letters, digits and hyphens.
std::string chart_name(const Part& part, const Scopes& scopes);

/// Returns the chart that a [[section.chart]] of a template declares, see page_template.h. Throws
/// std::logic_error if it does not fit the data.
Chart chart_of(const Part& part, const Scopes& scopes);

/// Returns where the cells of its heat map lead, by the texts `row_link` and `column_link`.
CellLinks cell_links_of(const Part& part, const Scopes& scopes);

/// Returns the table that a [[section.table]] of a template declares, see page_template.h. Throws
/// std::logic_error if it does not fit the data.
Table table_of(const Part& part, const Scopes& scopes);

}  // namespace ricochet::report
