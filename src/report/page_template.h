#pragma once

#include <toml++/toml.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "src/report/chart.h"
#include "src/report/json.h"
#include "src/report/page.h"
#include "src/report/text.h"

namespace ricochet::report {

/// Version of this struct. Data of another version are not read.
inline constexpr int headline_version = 1;

/// A place in a report, from one of its pages: "" is that page, "#thresholds" a section of it,
/// "count" a page in a folder below, "../count" one beside it.
struct Link {
  std::string text;
  std::string to;
};

/// A part of a report that the front page repeats.
struct Excerpt {
  std::string topic;  ///< the front page's heading for it
  std::string heading;
  std::string text;
  std::vector<Link> links;
  Table table;  ///< empty if it has no columns
};

/// A report's summary for a front page. It is stored in data.json, except for the parts repeated
/// from the page, which are drawn from the data when needed.
struct Headline {
  int version = 0;
  std::string title;
  std::string finding;             ///< the result, in a sentence
  std::string command;             ///< that made it; empty: that of its kind, with the time
  std::vector<std::string> holds;  ///< data for interactive parts of a front page, see src/site
  std::string group, label;  ///< in the navigation, of a further page that stands in it by itself
  std::vector<Excerpt> excerpts;
  std::vector<Chart> charts;  ///< named like the sections that they link to
};
RICOCHET_FIELDS(Headline, version, title, finding, command, holds);

NLOHMANN_JSON_SERIALIZE_ENUM(Scale,
                             {{Scale::linear, "linear"}, {Scale::logarithmic, "logarithmic"}})
NLOHMANN_JSON_SERIALIZE_ENUM(Mark, {{Mark::line, "line"},
                                    {Mark::steps, "steps"},
                                    {Mark::points, "points"}})
RICOCHET_FIELDS(Range, lower, upper);
RICOCHET_FIELDS(Axis, label, scale, range);
RICOCHET_FIELDS(Sample, position, value, name);
RICOCHET_FIELDS(Series, label, mark, pale, samples);
RICOCHET_FIELDS(Chart, name, title, x, y, series);

/// The result of filling in a template.
struct DrawnPage {
  Page page;
  std::map<std::string, std::string> tables;  ///< CSV of every table with rows, by file name
  std::string epilogue;                       ///< lines that end the command
  Headline headline;
};

/// Fills in a template. The template is TOML; its texts are Mustache, see text.h.
///
///   title = "..."             intro = ["a paragraph", ...]        epilogue = "..."
///   above = "name of the page in the folder above", if there is one
///   [digits]                  name = number of its significant digits in the data
///   [headline]                label, problem, command of the kind; finding, made_by, holds
///   [[headline.excerpt]]      topic, heading, text, links = [{text, to}, ...], table,
///                             see page_template.h
///   [[headline.chart]]        like a section's; omits samples at or above the end of y's range
///   [[section]]               id, heading, text = ["a paragraph", ...]
///     view                    name of the runs that a reader filters, see
///     reports/templates/view.js
///   [[section.table]]         rows, csv, most, caption, columns = [...], heads each a table
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

/// A table of a template. Throws std::logic_error if a key is missing or has another type. The
/// parsed template must outlive it.
class TemplatePart {
 public:
  explicit TemplatePart(const toml::table& table) : table_(&table) {}

  bool has(std::string_view key) const { return table_->contains(key); }

  std::string text(std::string_view key) const;

  /// The text with its names filled in; "" where the key is missing.
  std::string filled_text(std::string_view key, const Scopes& scopes) const;

  /// Returns a text, or a list of texts.
  std::vector<std::string> texts(std::string_view key) const;

  /// Null if the key is missing or is not a list.
  const toml::array* list(std::string_view key) const { return (*table_)[key].as_array(); }

  /// The table of that key.
  TemplatePart part(std::string_view key) const;

  /// The tables in the list of that key; empty if it is missing.
  std::vector<TemplatePart> parts(std::string_view key) const;

  /// A number in the template, or the number of a name in the data; nothing if the key or the data
  /// are missing.
  std::optional<double> number(std::string_view key, const Scopes& scopes) const;

 private:
  const toml::table* table_;
};

/// Adds the data as the innermost scope.
Scopes with(Scopes scopes, const Json& data);

/// Returns the scopes for each repetition of a part: none unless `when` holds, one for each entry
/// of the list `each`, or else one; the data named by `data` become the innermost scope.
std::vector<Scopes> places_of(const TemplatePart& part, const Scopes& scopes);

/// Returns true if a condition of the template holds: a name whose data must be true, or with a ^
/// before it must not be.
bool holds(const std::string& condition, const Scopes& scopes);

/// A number, or the name of one in the data: "name:%" converts a share to per cent, "name:size"
/// drops the sign. Nothing if the data are null or not finite.
std::optional<double> number_in(const toml::node& value, const Scopes& scopes);

/// Returns the data with every list of objects that have the same names in the same order as a
/// table, {"columns": [names], "rows": [[values], ...]}, at all depths. Throws std::logic_error if
/// the data have an object with exactly these two names.
Json packed(const Json& data);

/// Inverse of packed(). Anything that is not such a table is unchanged.
Json unpacked(Json data);

/// Returns the title of a template's page, and the contents of its [headline], see page_template.h;
/// version 0 if it has none.
Headline headline_of(const TemplatePart& page, const Scopes& scopes);

/// Returns the chart's name, in lower-case letters, digits and hyphens.
std::string chart_name(const TemplatePart& part, const Scopes& scopes);

/// Returns the chart that a [[section.chart]] of a template declares, see page_template.h. Throws
/// std::logic_error if it does not fit the data.
Chart chart_of(const TemplatePart& part, const Scopes& scopes);

/// Returns where the cells of its heat map lead, by the texts `row_link` and `column_link`.
CellLinks cell_links_of(const TemplatePart& part, const Scopes& scopes);

/// Returns the table that a [[section.table]] of a template declares, see page_template.h. Throws
/// std::logic_error if it does not fit the data.
Table table_of(const TemplatePart& part, const Scopes& scopes);

}  // namespace ricochet::report
