#pragma once

#include "src/report/chart.h"
#include "src/report/json.h"

namespace ricochet::report {

/// The chart as data, from which chart_of makes the same chart again, but for samples in the midst
/// of a level line. Members may be added that the template's title and caption use. Numbers that
/// are not finite become null, as gaps do.
Json data_of(const Chart& chart);

/// Throws std::invalid_argument or nlohmann's exceptions where the data are no chart's.
Chart chart_of(const Json& data);

}  // namespace ricochet::report
