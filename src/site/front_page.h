#pragma once

#include <string>

#include "src/report/file_set.h"
#include "src/report/json.h"

namespace ricochet::site {

/// The files of a front page, drawn from what was collected of the reports: index.html, which needs
/// no other file and no network, and summary.md.
report::FileSet front_page(const report::Json& data, const std::string& navigation);

}  // namespace ricochet::site
