#pragma once

#include <string>
#include <vector>

#include "problems/family.h"
#include "src/report/page.h"

/// The questions in words, tables and charts, all from the families themselves.
namespace ricochet::studies::problems {

/// What families there are; `machines` says of what those of the carrier track are.
report::Page overview_of(const std::vector<Family>& families, const std::string& machines);

/// The page of a family that has questions. One of one variable has a chart, of the fourth
/// question, C4, or of the only one.
report::Page page_of(const Family& family);

}  // namespace ricochet::studies::problems
