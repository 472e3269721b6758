#pragma once

#include <string>

#include "src/report/chart.h"

namespace ricochet::report {

/// The numbers of a chart as a CSV file: a row for every sample, edge of an area, reference line or
/// cell, with the axes' labels as the names of the columns and up to ten significant digits. What
/// is missing is an empty field.
std::string csv_of(const Chart& chart);

}  // namespace ricochet::report
