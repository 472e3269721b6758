#pragma once

#include "src/report/headline.h"
#include "src/report/template_part.h"

namespace ricochet::report {

/// Returns the title of a template's page, and the contents of its [headline], see page_template.h;
/// version 0 if it has none.
Headline headline_of(const Part& page, const Scopes& scopes);

}  // namespace ricochet::report
