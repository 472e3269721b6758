#pragma once

#include <functional>
#include <string>
#include <vector>

namespace ricochet::site {

/// A part of a document from one heading to the next.
struct DocumentPart {
  std::string heading, anchor;
  std::string text;   ///< plain
  std::string prose;  ///< the same, of tables only the names of rows
};

/// A Markdown document as HTML.
struct Document {
  std::string title;  ///< the first heading
  std::string html;   ///< with anchors at the headings, as code hosts make them
  std::vector<DocumentPart> parts;
};

/// Returns where a link of the document leads on the site; empty if nowhere, then its text stays.
using LinkTarget = std::function<std::string(const std::string&)>;

/// Converts Markdown with tables (the dialect of GitHub). HTML in the text is dropped. Throws
/// std::runtime_error for text that the library does not accept.
Document document_of(const std::string& markdown, const LinkTarget& target);

}  // namespace ricochet::site
