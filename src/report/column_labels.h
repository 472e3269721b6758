#pragma once

#include <string>
#include <vector>

namespace ricochet::report {

/// Returns the titles of a table's columns as custom properties of CSS, not escaped for HTML:
/// --1:"solver";--2:"solved [%]"; On a narrow screen reports/templates/look.css writes them
/// before the cells. Empty for a table of so few columns that it fits there as it is.
std::string column_labels(const std::vector<std::string>& titles);

}  // namespace ricochet::report
