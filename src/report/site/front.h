#pragma once

#include <string>
#include <vector>

#include "src/report/report_files.h"
#include "src/report/results.h"
#include "src/report/site/entries.h"

namespace ricochet::site {

/// What all reports of a site say, for its own pages: values "comparison.finding", tables
/// "comparison-leaders" and charts "comparison-map", after the kind of the report that has them; of
/// several reports of a kind, those of the first. Table "reports": label, folder, finding, date,
/// command, version, compiler, origin ("of the reference" where this machine did not compute it).
/// Value "origins": what this machine has computed, if the rest is of the reference.
/// Table "missing": label, command and question of the kinds that are not there.
report::Results site_results(const std::vector<FoundReport>& reports);

struct OwnFiles {
  report::FileSet files;              ///< index.html (self-contained), summary.md, data.json
  std::vector<std::string> failures;  ///< a line for each chart that could not be drawn
};

/// The front page, and the page that says how to cite ricochet and how to repeat its reports.
OwnFiles front_page(const report::Results& site);
OwnFiles cite_page(const report::Results& site);

/// The page of a live machine, whose parts are in src/live/page: the simulator as a WebAssembly
/// module with sliders and charts, in one file that asks for no other. `navigation`: the links to
/// all reports, as HTML.
std::string live_page(const std::string& navigation);

}  // namespace ricochet::site
