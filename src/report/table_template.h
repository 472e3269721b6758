#pragma once

#include "src/report/table.h"
#include "src/report/template_part.h"

namespace ricochet::report {

/// Returns the table that a [[section.table]] of a template declares, see page_template.h. Throws
/// std::logic_error if it does not fit the data.
Table table_of(const Part& part, const Scopes& scopes);

}  // namespace ricochet::report
