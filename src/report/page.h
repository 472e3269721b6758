#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "src/report/chart.h"
#include "src/report/json.h"
#include "src/report/report_files.h"
#include "src/report/text.h"

namespace ricochet::report {

enum class Alignment { left, right };

/// Good and bad are also shown as a tick and a cross, since not every reader sees colours.
enum class State { neutral, good, bad };

struct Column {
  std::string title;
  Alignment alignment = Alignment::right;
};

struct Cell {
  std::string text;
  State state = State::neutral;
  std::string link = {};  ///< see Link in page_template.h; empty: none
};

/// The first cell of every row is its header.
struct Table {
  std::string caption;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;  ///< each as long as `columns`
};

struct Figure {
  Chart chart;
  std::string caption;
  /// The reader's choice that shows it: on a screen one of a section's choices is visible at a
  /// time, at first the first one; on paper all are. Empty: it is always visible.
  std::string choice = {};
  /// Of the frames of a choice one is visible at a time, at first and on paper the last one. A
  /// slider, which needs a script, selects the frame and shows this label. Empty: it is not a
  /// frame.
  std::string frame = {};
  /// Heading under which it is folded away until the reader opens it. Empty: it is not folded.
  std::string fold = {};
  /// Why it could not be drawn; then only name and title of the chart are used. Empty if it was
  /// drawn.
  std::string failure = {};
  CellLinks links = {};  ///< of a heat map; they need a script
};

/// A heading and its contents: paragraphs, code, figures, tables, notes. Text is plain;
/// https:// addresses become links.
struct Section {
  std::string id;  ///< the address of the section within the page; unique, without spaces
  std::string heading;
  std::vector<std::string> paragraphs = {};
  std::vector<Table> tables = {};
  std::vector<Figure> figures = {};     ///< narrow ones stand side by side
  std::vector<std::string> code = {};   ///< shown as it is, after the paragraphs: commands
  std::vector<std::string> notes = {};  ///< paragraphs on how it was computed, folded on a screen
  /// Data of runs that a script filters, see reports/templates/view.js. Null: there is no view.
  Json view = {};
};

struct Page {
  std::string title;
  std::vector<std::string> intro;  ///< paragraphs: the answer
  std::vector<Section> sections;
  std::vector<std::string> background = {};  ///< paragraphs: the question, folded on a screen
  // The summary links these, as the navigation of the site does for the page:
  std::string above = {};                 ///< name of the page in the folder above, if any
  std::vector<std::string> further = {};  ///< folders of further pages
};

/// Writes index.html, which needs no other file and no network, summary.md, one SVG for each chart
/// and the files in `beside` into the folder, which is created if needed. Replaces the files of an
/// earlier report, including its other charts, and leaves every other file unchanged. A chart that
/// cannot be drawn is replaced by the reason; returns a line for each of them, see failure_of.
/// Throws InputError, with nothing changed, if the folder cannot be written; std::invalid_argument
/// if ids or charts' names repeat or a table is invalid.
[[nodiscard]] std::vector<std::string> write_page(const Page& page,
                                                  const std::filesystem::path& folder,
                                                  FileSet beside = {});

}  // namespace ricochet::report
