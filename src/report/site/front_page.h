#pragma once

#include <string>
#include <vector>

#include "src/report/page.h"
#include "src/report/site/front.h"
#include "src/report/site/navigation.h"

namespace ricochet::site {

struct FrontPage {
  report::FileSet files;              ///< index.html (self-contained), summary.md, data.json
  std::vector<std::string> failures;  ///< a line for each chart that could not be drawn
};

/// Draws the front page.
FrontPage front_page(const Front& front, const std::string& navigation);

/// The page of a live machine, whose parts are in src/live/page: the simulator as a WebAssembly
/// module with sliders and charts, in one file that asks for no other. `navigation`: the links to
/// all reports, as HTML.
std::string live_page(const std::string& navigation);

/// The page that says how to cite ricochet and how to repeat its reports: BibTeX, versions, seeds,
/// plan, digest, archive and commands. `comparison`: the one whose runs are described, or null.
OwnPage cite_page(const std::vector<FoundReport>& reports, const FoundReport* comparison);

}  // namespace ricochet::site
