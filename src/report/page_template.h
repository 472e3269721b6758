#pragma once

#include <map>
#include <string>

#include "src/report/data_text.h"
#include "src/report/headline.h"
#include "src/report/json.h"
#include "src/report/page.h"

namespace ricochet::report {

/// The result of filling in a template.
struct DrawnPage {
  Page page;
  std::map<std::string, std::string> tables;  ///< CSV of every table with rows, by file name
  std::string epilogue;                       ///< lines that end the command
  Headline headline;
};

/// Fills in a template. The template is TOML; its texts are Mustache, see filled_text.h.
///
///   title = "..."             intro = ["a paragraph", ...]        epilogue = "..."
///   above = "name of the page in the folder above", if there is one
///   [digits]                  name = number of its significant digits in the data
///   [headline]                label, problem, command of the kind; finding, made_by, holds
///   [[headline.excerpt]]      topic, heading, text, links = [{text, to}, ...], table,
///                             see headline.h
///   [[headline.chart]]        like a section's; omits samples at or above the end of y's range
///   [[section]]               id, heading, text = ["a paragraph", ...]
///     view                    name of the runs that a reader filters, see
///     reports/templates/view.js
///   [[section.table]]         rows, csv, most, caption, columns = [...], heads each a table
///   [section.explorer]        caption, settings, setting, values, value, answers, answer
///     a column                title, value, align = "left" (default right), state, link
///   [[section.chart]]         name, title, caption, x, y, series, lines, heat_map
///     an axis, x or y         label with its unit, scale = "logarithmic", range = [from, to],
///                             categories, where, category, order = "down" (default up)
///     a series                label, mark = "steps" or "points" (default line),
///                             look = "pale" (default coloured), name of each point,
///                             rows, where, x, y, lower, upper, start; or samples = [[x, y], ...]
///     a line                  label; vertical, a place on x, or horizontal, one on y
///     the heat_map            label of the colours, cells, value, range
///
/// If the data have no `finding`, texts use that of the headline.
///
/// `rows` names a list of rows in the data. `csv` is the stem of the file that stores the rows;
/// without it there is no file. If there are more rows than `most`, the others are only in that
/// file. Rows of a table can also be given directly, rows = [["a cell", ...], ...]; then columns
/// have only titles. `state` names a member of a row: true is good, false is bad. Texts of a cell
/// look up names in the row first. An empty paragraph is omitted.
///
/// In a chart, x, y, range, vertical, horizontal and value are numbers, or names of numbers in the
/// data: "share:%" converts to per cent, "error:size" drops the sign. x and y are looked up in the
/// row first; without x the position is the index of the row, from 0. `where` names data of a row
/// that must be true, or with a ^ before it must not be; `rows` of a series may be several lists,
/// which are concatenated. Joined samples are sorted. A number that is missing, or not positive on
/// a logarithmic axis, is a gap; a line or a range with such a number is omitted. `lower` and
/// `upper` are the bounds of the spread around y. A series with a `start` begins at that value, at
/// the position of its first sample.
///
/// `categories` names a list whose entries label the axis instead of numbers, with the text
/// `category`, which looks up names in the entry first. A heat map has a row for each entry of y:
/// `cells` names a list in that entry, with an entry for each of x, and `value` a member of it, or
/// "." for the entry itself. A chart's name is converted to lower-case letters, digits and hyphens;
/// `width` and `height` are pixels, and `row_height` is added for each category of y; `description`
/// is for readers who cannot see the chart. The reader selects it by its `choice`, a slider by its
/// `frame`, and a figure with a `fold` is folded away, see page.h.
///
/// In an explorer, `settings` names a list with an entry for each setting; its member `own` is the
/// index of the initial value; `setting` is its label, `values` a list in it, `value` the text of
/// each. `answers` names the list of answers, one for each combination, with the last setting
/// changing first, and `answer` is the text of each.
///
/// Any section, paragraph {text = "..."}, table, column, chart, series and line can have `when`, a
/// condition like `where`; `each`, the name of a list for whose entries it is repeated, with names
/// looked up in the entry first; and `data`, the name of data in which names are looked up before
/// that. A column with `each` has `cells`, the name of a list of the same length in the row, in
/// which its text looks up names.
///
/// A list `pages` in the data has the folders of further pages, which the summary links to.
///
/// Throws std::logic_error, with place and reason, if the template does not fit the data; with
/// Mismatch::costs_its_chart, a chart that does not fit is replaced by the reason.
enum class Mismatch { throws, costs_its_chart };
DrawnPage drawn(const std::string& page_template, const Json& data,
                Mismatch mismatch = Mismatch::throws);

/// Returns a report's summary for a front page; version 0 if the template has no headline. Throws
/// as above.
Headline headline_in(const std::string& page_template, const Json& data);

/// Returns the number of significant digits that the template's report keeps, by name, from its
/// table `digits`.
Digits kept_digits(const std::string& page_template);

}  // namespace ricochet::report
