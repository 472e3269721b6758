#pragma once

#include <map>
#include <string>

#include "src/report/json.h"
#include "src/report/page.h"

namespace ricochet::report {

/// What a template makes of data.
struct DrawnPage {
  Page page;
  std::map<std::string, std::string> tables;  ///< CSV of every table with rows, by file name
  std::string epilogue;                       ///< lines that end the command
};

/// Fills a template in. The template is TOML; its texts are Mustache, see filled_text.h.
///
///   title = "..."             intro = ["a paragraph", ...]        epilogue = "..."
///   [[section]]               id, heading, text = ["a paragraph", ...]
///   [[section.table]]         rows, csv, caption, columns = [...], heads each a table
///     a column                title, value, align = "left" (default right), state
///   [[section.chart]]         chart, title, caption
///
/// `rows` and `chart` name data: a list of rows, a chart or a list of charts (chart_data.h). `csv`
/// is the stem of the file that keeps the rows; without one none does. Rows can also be written out
/// in the template, rows = [["a cell", ...], ...]; then columns have titles only. `state` names a
/// member of a row: true is good, false is bad. Texts of a cell look names up in the row first,
/// those of a chart in the chart. A paragraph that comes out empty is left out.
///
/// Any section, paragraph {text = "..."}, table, column and chart takes `when`, a name that must be
/// a yes, and `each`, the name of a list for whose entries it is repeated, in each of which names
/// are looked up first; a section also `data`, the name of data in which its names are looked up
/// first. A column with `each` takes `cells`, the name of a row's list, as long: its text looks
/// names up there.
///
/// Throws std::logic_error, with what is wrong where, for a template that does not fit the data.
DrawnPage drawn(const std::string& page_template, const Json& data);

}  // namespace ricochet::report
