#pragma once

#include <string>
#include <vector>

#include "src/report/file_set.h"
#include "src/report/site/front.h"

namespace ricochet::site {

struct FrontPage {
  report::FileSet files;              ///< index.html (self-contained), summary.md, data.json
  std::vector<std::string> failures;  ///< a line for each chart that could not be drawn
};

/// Draws the front page.
FrontPage front_page(const Front& front, const std::string& navigation);

}  // namespace ricochet::site
