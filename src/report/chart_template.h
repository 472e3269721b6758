#pragma once

#include "src/report/chart.h"
#include "src/report/template_part.h"

namespace ricochet::report {

/// The chart that a [[section.chart]] of a template declares, see page_template.h. Throws
/// std::logic_error where it does not fit the data.
Chart chart_of(const Part& part, const Scopes& scopes);

}  // namespace ricochet::report
