#pragma once

#include <map>
#include <string>

#include "src/report/data_text.h"
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
///   above = "what the page in the folder above is called", where there is one
///   [digits]                  name = how many significant digits of it the data keep
///   [[section]]               id, heading, text = ["a paragraph", ...]
///   [[section.table]]         rows, csv, most, caption, columns = [...], heads each a table
///   [section.explorer]        caption, settings, setting, values, value, answers, answer
///     a column                title, value, align = "left" (default right), state
///   [[section.chart]]         name, title, caption, x, y, series, lines, heat_map
///     an axis, x or y         label with its unit, scale = "logarithmic", range = [from, to],
///                             categories, category, order = "down" (default up)
///     a series                label, mark = "steps" or "points" (default line),
///                             look = "pale" (default coloured), name of each point,
///                             rows, where, x, y, lower, upper; or samples = [[x, y], ...]
///     a line                  label; vertical, a place on x, or horizontal, one on y
///     the heat_map            label of the colours, cells, value, range
///
/// `rows` names data: a list of rows. `csv` is the stem of the file that keeps the rows; without
/// one none does; of more rows than `most` the others are there alone. Rows of a table can also be
/// written out, rows = [["a cell", ...], ...]; then columns have titles only. `state` names a
/// member of a row: true is good, false is bad. Texts of a cell look names up in the row first. A
/// paragraph that comes out empty is left out.
///
/// Of a chart, x, y, range, vertical, horizontal and value are numbers, or names of numbers in the
/// data: "share:%" in hundredths, "error:size" without its sign. x and y are looked up in the row
/// first; without x the position is the number of the row, from 0. `where` names what must be a yes
/// in a row, with a ^ before it what must not; `rows` of a series may be several lists, one after
/// the other. Joined samples are put in order. A number that is missing, or not positive on a
/// logarithmic axis, is a gap; a line at one is left out, and so is a range that ends at one.
/// `lower` and `upper` bound the spread around y.
///
/// `categories` names a list whose entries the axis has instead of numbers, each as the text
/// `category` says, which looks names up in the entry first. A heat map has a row for each entry of
/// y: `cells` names a list there, of an entry for each of x, and `value` a member of it, or "." for
/// itself. A chart's name is written in small letters, with hyphens; `width` and `height` are
/// pixels, `row_height` those more for each category of y; `description` is for those who cannot
/// see it; by its `choice` the reader picks it among others of the section, by its `frame` a slider
/// does, and what has a `fold` is folded away, see page.h.
///
/// Of an explorer, `settings` names a list, of an entry for each, with a member `own`, the number
/// of the value that is set at the beginning; `setting` is its label, `values` a list in it,
/// `value` the text of each. `answers` names the list of answers, one for each combination, of
/// which the last setting changes first, and `answer` is the text of each.
///
/// Any section, paragraph {text = "..."}, table, column, chart, series and line takes `when`, a
/// condition like `where`, `each`, the name of a list for whose entries it is repeated, in each of
/// which names are looked up first, and `data`, the name of data in which they are looked up before
/// that. A column with `each` takes `cells`, the name of a row's list, as long: its text looks
/// names up there.
///
/// A list `pages` in the data has the folders of further pages, which the summary links.
///
/// Throws std::logic_error, with what is wrong where, for a template that does not fit the data.
DrawnPage drawn(const std::string& page_template, const Json& data);

/// How many digits of numbers the template's report keeps, by name: what its table `digits` says.
Digits kept_digits(const std::string& page_template);

}  // namespace ricochet::report
