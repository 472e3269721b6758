#pragma once

#include "src/site/found_report.h"

namespace ricochet::site {

/// The first sentence of the first paragraph that begins with "Found:", without that word; else of
/// the first of all. Empty where there is no paragraph.
std::string verdict_of(const std::vector<std::string>& paragraphs);

/// What the front page says of a report: title, verdict, date, quick or full, command.
Json card_of(const FoundReport& report);

/// The kinds of which there is no report: what it would answer, and the command that makes it.
Json missing_cards(const std::vector<FoundReport>& reports);

}  // namespace ricochet::site
