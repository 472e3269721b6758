#pragma once

#include <string>
#include <vector>

#include "problems/family.h"
#include "src/report/page.h"

/// The problems in words, tables and charts, all from the families themselves.
namespace ricochet::catalogue {

/// A page of all families, which say of what `machines` they are. A chart is of the fourth problem
/// of a family of one variable, C4, or of the only one.
report::Page page_of(const std::vector<Family>& families, const std::string& machines);

}  // namespace ricochet::catalogue
