#pragma once

#include <string>
#include <vector>

#include "src/report/json.h"

namespace ricochet::report {

/// Data in which a template looks a name up, from the last one to the first.
using Scopes = std::vector<const Json*>;

/// The data that a name stands for: "name", "table.name", or "." for the innermost scope itself.
/// Throws std::logic_error where no scope has it.
const Json& found_in(const Scopes& scopes, const std::string& name);

/// Whether a template's condition takes the data for a yes: all but null, false, "" and an empty
/// list. A zero is a number like others.
bool is_yes(const Json& data);

/// A Mustache text, filled in. {{name:form}} formats as fmt's {:form} does, of a share with a form
/// that ends in % so many hundredths; null becomes a dash, and what rounds to zero has no sign.
/// {{#name}}...{{/name}} stands where the data are a yes, once for each entry of a list;
/// {{^name}}...{{/name}} where not. The name @first is a yes in the first entry of a list, so that
/// {{^@first}}, {{/@first}} separates entries. Nothing is escaped. Throws std::logic_error for a
/// text that is no Mustache, or a name that has no data.
std::string filled(const std::string& text, const Scopes& scopes);

}  // namespace ricochet::report
