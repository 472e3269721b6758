#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/report/chart.h"
#include "src/report/page.h"
#include "src/report/site/chooser.h"
#include "src/report/site/entries.h"
#include "src/report/site/navigation.h"
#include "src/report/site/paper_machines.h"

namespace ricochet::site {

/// A link of an excerpt, with the folder of its report.
struct FrontLink {
  std::string text;
  std::string folder;  ///< of the page, relative to the front page; empty: the front page
  std::string anchor;  ///< with its #, or empty
};

/// A cell of an excerpt's table, with an optional link to a page.
struct FrontCell {
  std::string text, folder, anchor;
  bool left;
};

struct FrontRow {
  std::vector<FrontCell> cells;
};

struct FrontColumn {
  std::string title;
  bool left;
};

/// A part of a report, as the front page repeats it.
struct FrontExcerpt {
  std::string heading = {}, text = {};
  std::vector<FrontLink> links = {};
  std::string caption = {};
  std::vector<FrontColumn> columns = {};
  std::vector<FrontRow> rows = {};
};

/// One report in the list of all reports.
struct Card {
  std::string folder, label, title, finding;
  std::optional<std::string> date;
  bool quick;
  std::optional<double> seconds;
  std::string command;
};

/// The charts of a report, of which the front page shows one at a time.
struct FrontCharts {
  std::string folder;
  std::vector<report::Chart> charts;
};

/// The content of the front page.
struct Front {
  std::vector<FrontExcerpt> answers = {};                           ///< in a sentence each
  std::vector<FrontExcerpt> speed, solver, own, question, entries;  ///< excerpts by their topic
  std::optional<PaperMachines> machines = {};                       ///< not written
  std::optional<Chooser> chooser = {};
  std::int64_t runs = 0, problems = 0, solvers = 0;  ///< of the comparison
  std::optional<Comparison> comparison;
  std::optional<FrontCharts> motion;
  std::optional<Pairs> pairs;
  std::vector<Card> cards;
  std::vector<report::ReportKind> missing;  ///< kinds of which there is no report
  /// Folder and reason of each report with a headline whose data cannot be read; not written.
  std::vector<std::pair<std::string, std::string>> unread;
};

RICOCHET_FIELDS(FrontLink, text, folder, anchor);
RICOCHET_FIELDS(FrontCell, text, folder, anchor, left);
RICOCHET_FIELDS(FrontRow, cells);
RICOCHET_FIELDS(FrontColumn, title, left);
RICOCHET_FIELDS(FrontExcerpt, heading, text, links, caption, columns, rows);
RICOCHET_FIELDS(Card, folder, label, title, finding, date, quick, seconds, command);
RICOCHET_FIELDS(FrontCharts, folder, charts);
RICOCHET_FIELDS(Front, answers, speed, solver, own, question, entries, chooser, comparison, motion,
                pairs, cards, missing);

/// Collects the headlines of the reports.
Front front_of(const std::vector<FoundReport>& reports);

/// Returns the static charts of a front page, for paper and for readers without scripts, from the
/// same data as the interactive ones: speed against accuracy of each family with its largest
/// budget, and the first of the reports' charts. Empty charts are omitted.
std::vector<report::Chart> front_charts(const Front& front);

/// Shows for each simulation the pair with its fastest solver, and all pairs on the Pareto front;
/// the other pairs would lie to the right.
report::Chart pairs_chart(const Pairs& pairs);

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
