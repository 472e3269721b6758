#pragma once

#include "src/site/found_report.h"

namespace ricochet::site {

/// Questions that a stranger asks, in a stranger's words, as far as the reports answer them: each
/// with question, answer (a sentence or two, all of it from the data), and links (text, page as
/// folders, anchor or ""), of which the first leads to where the report answers at length.
Json questions_data(const std::vector<FoundReport>& reports);

}  // namespace ricochet::site
