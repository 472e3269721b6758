#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "src/report/report_files.h"
#include "src/report/results.h"

namespace ricochet::report {

/// A page as it stands beside its study: Markdown with names to fill in.
///
///   ---
///   group: Machine            where the navigation has it
///   label: Fit                and how
///   question: ...             that it answers
///   command: ./ricochet ...   that makes it
///   finding: {{finding}}      the answer in a sentence, for other pages
///   terminal: name, name      values and tables that end the command; a table may be followed by
///                             those of its columns that a person needs
///   made_by: ...              the command, where it was another
///   ---
///   # Title
///
///   {{name}} and {{name:.2f}} are values, see text_of(ricochet::Value). A value of the innermost
///   part hides those around it.
///
///   {{table NAME}}            a table with all its columns; {{table NAME 20}}: at most 20 rows,
///   and
///                             a link to the CSV file with the others
///   | {{NAME.column}} | ...   a line of a Markdown table or of a list: once for each row of the
///   table
///   {{chart NAME}} A caption. A picture
///
///   {{choose NAME: Label}}    what follows once for each part of that name; a screen shows the one
///   ...                       that the reader chooses
///   {{end}}
///   {{view}}                  a form that filters the runs of the tables view-*, see view.js
///   {{fold Heading}}          what follows is folded away until the reader opens it
///   ...
///   {{end}}
///
/// A block between empty lines that needs a missing value, a table without rows, or a chart or
/// parts that are not there, is left out; in a table or a list, only the cell or the item; and a
/// heading under which nothing is left. A link to a folder, [text](../count/#section), leads to its
/// page.
struct PageSource {
  std::map<std::string, std::string, std::less<>> keys;
  std::string text;
};

/// Throws std::logic_error if the file does not begin with keys.
PageSource page_source(std::string_view file);

/// The page's title, its first heading.
std::string title_of(const PageSource& page, const Results& results);

/// One line of a page, such as its finding, filled in without escaping; "" if a value is missing.
std::string filled_line(std::string_view line, const Results& results);

/// The filled page as Markdown. Throws std::logic_error if it asks for a value or for the column of
/// a table that the results do not have, if a chooser or a fold does not end, or if a part's id is
/// no address.
std::string filled_page(const PageSource& page, const Results& results);

/// The values and tables that end a command, as text.
std::string terminal_text(const PageSource& page, const Results& results);

/// A page as files: index.html, summary.md, a picture of each chart that the page shows, and a CSV
/// file of each table.
struct PageFiles {
  FileSet files;
  std::vector<std::string> failures;  ///< a line for each chart that could not be drawn
};
/// `pictures`: further SVGs by name, which the page shows by a value ![title](name.svg).
PageFiles page_files(const PageSource& page, const Results& results,
                     const std::map<std::string, std::string>& pictures = {});

}  // namespace ricochet::report
