#pragma once

#include <string>
#include <vector>

#include "src/report/json.h"

namespace ricochet::report {

/// Data in which a template looks up a name, from the last to the first.
using Scopes = std::vector<const Json*>;

/// Returns the data of a name: "name", "table.name", or "." for the innermost scope itself. Throws
/// std::logic_error if no scope has it.
const Json& found_in(const Scopes& scopes, const std::string& name);

/// Returns true if a template's condition holds for the data: unless they are null, false, "" or an
/// empty list. Zero counts as true.
bool is_yes(const Json& data);

/// Fills in a Mustache text. {{name:format}} formats as fmt's {:format} does; for a share, a format
/// that ends in % gives per cent. Null becomes a dash, and a number that rounds to zero has no
/// sign. {{#name}}...{{/name}} is included if the data are true, once for each entry of a list;
/// {{^name}}...{{/name}} if they are not. The name @first is true in the first entry of a list, so
/// that {{^@first}}, {{/@first}} separates entries; @last in the last. Nothing is escaped. Throws
/// std::logic_error if the text is not valid Mustache, or if a name has no data.
std::string filled(const std::string& text, const Scopes& scopes);

}  // namespace ricochet::report
